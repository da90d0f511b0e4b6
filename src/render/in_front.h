#pragma once

class vtkActor;

namespace gnathion {

/// Prepares an actor for in_front(). Once an actor, before its first frame.
void allow_in_front(vtkActor* actor);

/// true: the actor is drawn before all that is not, whatever lies between it and the eye, among its
/// like by their depth; false: as any other. \pre allow_in_front(actor)
void set_in_front(vtkActor* actor, bool in_front);

}  // namespace gnathion
