#pragma once

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>

#include <algorithm>
#include <string>

namespace gnathion {

/// Collects what a VTK object complains about, which VTK would otherwise print. For .cpp files.
class VtkErrors {
 public:
  explicit VtkErrors(vtkObject* object) {
    command_->SetClientData(&text_);
    command_->SetCallback([](vtkObject*, unsigned long, void* text, void* message) {
      auto& all = *static_cast<std::string*>(text);
      if (all.empty() && message) all = static_cast<const char*>(message);
    });
    object->AddObserver(vtkCommand::ErrorEvent, command_);
    object->AddObserver(vtkCommand::WarningEvent, warnings_);
  }
  VtkErrors(const VtkErrors&) = delete;
  VtkErrors& operator=(const VtkErrors&) = delete;

  /// The first complaint, on one line without VTK's source location; empty when there was none.
  std::string text() const {
    std::string line = text_;
    if (const auto at = line.find("): "); at != std::string::npos) line.erase(0, at + 3);
    std::replace(line.begin(), line.end(), '\n', ' ');
    while (!line.empty() && line.back() == ' ') line.pop_back();
    return line;
  }

 private:
  std::string text_;
  vtkNew<vtkCallbackCommand> command_;
  vtkNew<vtkCallbackCommand> warnings_;
};

}  // namespace gnathion
