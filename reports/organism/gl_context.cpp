#include "organism/gl_context.h"

#include <GL/osmesa.h>
#include <dlfcn.h>
#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <latch>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/error.h"

// OSMesa never frees a few hundred bytes for each context's framebuffer. The leak checker of sanitizer builds ignores
// this leak, and prints no list of ignored leaks, because tests check standard error.
#if defined(__has_feature)
#define MORULA_ASAN __has_feature(address_sanitizer)
#elif defined(__SANITIZE_ADDRESS__)
#define MORULA_ASAN 1
#else
#define MORULA_ASAN 0
#endif
#if MORULA_ASAN
extern "C" const char* __lsan_default_suppressions() { return "leak:libOSMesa"; }
extern "C" const char* __lsan_default_options() { return "print_suppressions=0"; }
#endif

namespace morula {

#define MORULA_GL_FUNCTION(name) decltype(&::name) name = nullptr;
MORULA_GL_FUNCTIONS(MORULA_GL_FUNCTION)
#undef MORULA_GL_FUNCTION

struct OffscreenContext::Handle {
  OSMesaContext context = nullptr;
  // OSMesa requires a default framebuffer; nothing is drawn into it
  std::array<unsigned char, 4 * 16 * 16> pixels{};
};

namespace {

/// Removes environment variables that users set for other programs, and those that would select another driver, an
/// older OpenGL or different pixels.
void unsetMesaVariables() {
  std::vector<std::string> names;
  for (char** entry = environ; *entry; ++entry) {
    const std::string name(*entry, std::strcspn(*entry, "="));
    for (const char* family : {"GALLIUM_", "GALLIVM_", "LP_", "MESA_"})
      if (name.starts_with(family) && !name.starts_with("MESA_SHADER_CACHE_")) names.push_back(name);
  }
  for (const std::string& name : names) unsetenv(name.c_str());
}

/// Configures the driver, once. llvmpipe compiles shaders for the CPU. Even at 128 bits it fuses multiplications with
/// additions if the CPU can, which changes one pixel in ten thousand by a level. Limited to SSE 4.1 it does not, and
/// pixels are the same on every x86-64. The shader cache saves 0.05 s per process but writes into the user's home
/// directory, so it is off unless the environment enables it.
void settleDriver() {
  static std::once_flag once;
  std::call_once(once, [] {
    unsetMesaVariables();
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 1);
    setenv("GALLIUM_OVERRIDE_CPU_CAPS", "sse4.1", 1);
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
    if (threadsToDraw() == 1) setenv("LP_NUM_THREADS", "0", 1);  // llvmpipe would wait for missing threads forever
  });
}

decltype(&::OSMesaCreateContextAttribs) createContext = nullptr;
decltype(&::OSMesaDestroyContext) destroyContext = nullptr;
decltype(&::OSMesaMakeCurrent) makeContextCurrent = nullptr;

template <class Function>
void find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(::dlsym(library, name));
  if (!function) throw FileError(std::string(MORULA_OSMESA) + " has no " + name);
}

/// Loads the driver, once; it stays loaded until the process ends.
void loadDriver(const std::string& remedy) {
  static std::once_flag once;
  std::call_once(once, [&] {
    void* const library = ::dlopen(MORULA_OSMESA, RTLD_LAZY | RTLD_LOCAL);
    const std::string why = library ? "" : ::dlerror();
    for (const char* words : {"failed to map segment from shared object", "zero-fill pages", "llocate memory"})
      if (why.ends_with(words))  // a message with another errno has another cause
        throw NumericalError("there is not enough memory to draw: " + why + remedy, Want::memory);
    if (!library) throw FileError("nothing can be drawn: " + why);
    find(library, "OSMesaCreateContextAttribs", createContext);
    find(library, "OSMesaDestroyContext", destroyContext);
    find(library, "OSMesaMakeCurrent", makeContextCurrent);
#define MORULA_GL_FUNCTION(name) find(library, #name, name);
    MORULA_GL_FUNCTIONS(MORULA_GL_FUNCTION)
#undef MORULA_GL_FUNCTION
  });
}

/// [byte] Address space for compiled shaders, threads and framebuffers. With 320 MB drawing failed now and then,
/// depending on when threads ask for memory.
constexpr double ofContext = 450e6;

}  // namespace

void requireMemoryToDraw(double bytes, const std::string& remedy) {
  const auto all = static_cast<std::size_t>(bytes);
  void* const place = ::mmap(nullptr, all, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (place == MAP_FAILED)
    throw NumericalError(
        "there is not enough memory to draw; drawing takes " + std::to_string(all / 1'000'000) + " MB" + remedy,
        Want::memory);
  ::munmap(place, all);
}

int threadsToDraw() {
  static const int threads = [] {
    const int all = std::max(1, int(std::thread::hardware_concurrency()));
    std::latch over(1);
    std::vector<std::jthread> waiting;
    bool enough = true;
    try {  // llvmpipe starts up to `all` threads, and so do we
      while (int(waiting.size()) < 2 * all + 2) waiting.emplace_back([&] { over.wait(); });
    } catch (...) { enough = false; }  // for lack of threads or memory; waiting threads must be released
    over.count_down();
    return enough ? all : 1;
  }();
  return threads;
}

OffscreenContext::OffscreenContext() {
  const std::string remedy =
      ", however small the picture; draw on a machine with more memory, or run with --no-pictures";
  requireMemoryToDraw(ofContext, remedy);
  settleDriver();
  loadDriver(remedy);
  requireMemoryToDraw(ofContext, remedy);  // loading the library has taken some of the memory
  handle_ = std::make_unique<Handle>();
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_DEPTH_BITS,
                            0,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            4,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  handle_->context = createContext(attributes, nullptr);
  if (!handle_->context) throw BugError("OSMesa gives no OpenGL 4.3 context");
  makeCurrent();
}

OffscreenContext::~OffscreenContext() { destroyContext(handle_->context); }

void OffscreenContext::makeCurrent() {
  if (!makeContextCurrent(handle_->context, handle_->pixels.data(), GL_UNSIGNED_BYTE, 16, 16))
    throw BugError("OSMesa cannot make its context current");
}

}  // namespace morula
