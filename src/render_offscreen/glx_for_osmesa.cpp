// Debian's VTK loads OpenGL through libGLEW, which asks GLX for every function's address. GLX needs
// an X server. libGLEW imports just these three symbols, so a program that defines and exports them
// decides where OpenGL comes from: from OSMesa while an OSMesa context is current, otherwise from
// the real GLX. glXGetCurrentDisplay is asked for by address, hence the stand-in.
#include <GL/osmesa.h>
#include <dlfcn.h>

#include <cstring>

namespace {

using Function = void (*)();

void* no_display() {
  return nullptr;
}

template <typename Signature>
Signature* real(const char* name) {
  return reinterpret_cast<Signature*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

Function glXGetProcAddressARB(const unsigned char* name) {
  const char* text = reinterpret_cast<const char*>(name);
  if (!OSMesaGetCurrentContext()) {
    auto* glx = real<Function(const unsigned char*)>("glXGetProcAddressARB");
    return glx ? glx(name) : nullptr;
  }
  if (std::strcmp(text, "glXGetCurrentDisplay") == 0) {
    return reinterpret_cast<Function>(&no_display);
  }
  return reinterpret_cast<Function>(OSMesaGetProcAddress(text));
}

int glXQueryVersion(void* display, int* major, int* minor) {
  if (!OSMesaGetCurrentContext()) {
    auto* glx = real<int(void*, int*, int*)>("glXQueryVersion");
    return glx ? glx(display, major, minor) : 0;
  }
  *major = 1;
  *minor = 4;
  return 1;
}

const char* glXGetClientString(void* display, int name) {
  if (!OSMesaGetCurrentContext()) {
    auto* glx = real<const char*(void*, int)>("glXGetClientString");
    return glx ? glx(display, name) : "";
  }
  return "";
}

}  // extern "C"
