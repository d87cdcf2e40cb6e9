// A library for LD_PRELOAD that lets one operation fail: one on files below FAULT_FOLDER, or one that asks for memory.
// Operations of programs that the program starts are counted too.
//
//   FAULT=KIND:N:HOW   the N-th of KIND, counted from 1 and in all processes together
//     KIND  write, sync, rename, make (to open for writing, mkdir, truncate), remove, read (also to open),
//           files (all but read);
//           new (operator new), malloc (malloc, calloc and realloc, but not for operator new);
//           all: none fails, and each kind but `files` is counted for itself
//     HOW   a name of errno (ENOSPC, EIO); with a '+' all later operations fail too; short: half is written, then
//           the error; kill: the process ends by SIGKILL; killall: its whole group does. Memory: anything.
//   FAULT_COUNT=FILE   eight bytes, zero at first, for the number of operations; KIND `all` adds eight for each kind,
//                      in the order above. Without FAULT's N (0) operations are only counted.
//   FAULT_PLACES=FILE  for counting only: eight bytes per operation, a hash of the six innermost calls
//   FAULT_CLOCK=N      the clock is N seconds fast; also without FAULT
//
// Memory is counted from the beginning of main() to its end: before and after, nobody could report an error. Memory of
// Mesa, LLVM, cairo and font libraries is not counted, because these crash without memory; the program checks
// beforehand that there is enough.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <new>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
}

namespace {

using Counter = std::atomic<std::uint64_t>;

enum Kind { none, writes, syncs, renames, makes, removes, reads, files, news, mallocs, all };
constexpr const char* kindNames[] = {"",     "write", "sync", "rename", "make", "remove",
                                     "read", "files", "new",  "malloc", "all"};

struct Fault {
  Kind kind = none;
  std::uint64_t number = 0;
  int error = EIO;
  bool goesOn = false, isShort = false, kills = false, killsAll = false;
  char folder[PATH_MAX] = {};
  Counter* counts = nullptr;  // KIND `all` counts at the kind's number, others at 0
  int places = -1;            // a file descriptor
} fault;
bool inMain = false;

void readFault() {
  const char *what = std::getenv("FAULT"), *folder = std::getenv("FAULT_FOLDER"), *count = std::getenv("FAULT_COUNT");
  if (!what || !folder || !count) return;
  const char* const number = std::strchr(what, ':');
  const char* const how = number ? std::strchr(number + 1, ':') : nullptr;
  const int file = ::open(count, O_RDWR | O_CLOEXEC);
  void* const shared = ::mmap(nullptr, (all + 1) * sizeof(Counter), PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
  if (!how || shared == MAP_FAILED || !::realpath(folder, fault.folder)) {
    std::fprintf(stderr, "failing: FAULT, FAULT_FOLDER and FAULT_COUNT do not go together\n");
    ::_exit(99);
  }
  ::close(file);
  for (int k = writes; k <= all; ++k)
    if (std::strncmp(what, kindNames[k], static_cast<std::size_t>(number - what)) == 0 &&
        kindNames[k][number - what] == 0)
      fault.kind = static_cast<Kind>(k);
  fault.number = std::strtoull(number + 1, nullptr, 10);
  fault.error = std::strncmp(how, ":ENOSPC", 7) == 0 ? ENOSPC : EIO;
  fault.goesOn = how[std::strlen(how) - 1] == '+';
  fault.isShort = std::strcmp(how, ":short") == 0;
  fault.killsAll = std::strcmp(how, ":killall") == 0;
  fault.kills = fault.killsAll || std::strcmp(how, ":kill") == 0;
  fault.counts = static_cast<Counter*>(shared);
  if (const char* const places = std::getenv("FAULT_PLACES"); places && fault.number == 0)
    fault.places = ::open(places, O_WRONLY | O_CREAT | O_CLOEXEC, 0600);
}

thread_local bool isLooking = false;

/// Writes a hash of the calls that led to the n-th operation.
void notePlace(std::uint64_t n) {
  isLooking = true;  // memory of the backtrace is not counted
  void* calls[6];
  const int count = ::backtrace(calls, 6);
  std::uint64_t hash = 14695981039346656037u;
  for (int i = 0; i < count; ++i) hash = (hash ^ reinterpret_cast<std::uintptr_t>(calls[i])) * 1099511628211u;
  ::syscall(SYS_pwrite64, fault.places, &hash, sizeof hash, (n - 1) * sizeof hash);
  isLooking = false;
}

/// Counts an operation of this kind and returns true if it must fail.
bool isHit(Kind kind) {
  const std::uint64_t n = ++fault.counts[fault.kind == all ? kind : none];
  if (fault.places >= 0) notePlace(n);
  if (fault.number == 0 || !(n == fault.number || (fault.goesOn && n > fault.number))) return false;
  if (fault.killsAll) ::kill(0, SIGKILL);
  if (fault.kills) ::kill(::getpid(), SIGKILL);
  errno = fault.error;
  return true;
}

bool isCounted(Kind kind) {
  return fault.counts && (fault.kind == kind || (fault.kind == files && kind < reads) || fault.kind == all);
}

bool isOurs(const char* absolute) {
  const std::size_t length = std::strlen(fault.folder);
  return std::strncmp(absolute, fault.folder, length) == 0 && (absolute[length] == '/' || absolute[length] == 0);
}

bool fails(Kind kind, int descriptor) {
  if (!isCounted(kind)) return false;
  char link[64], path[PATH_MAX] = {};
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const int reason = errno;
  const bool ours = ::readlink(link, path, sizeof path - 1) > 0 && isOurs(path);
  errno = reason;
  return ours && isHit(kind);
}

bool fails(Kind kind, int folder, const char* path) {
  if (!isCounted(kind)) return false;
  if (path[0] == '/') return isOurs(path) && isHit(kind);
  if (folder != AT_FDCWD) return fails(kind, folder);
  char here[PATH_MAX];
  return ::getcwd(here, sizeof here) && isOurs(here) && isHit(kind);
}

struct Range {
  std::uintptr_t from, to;
} drivers[16];
int driverCount = 0;

int findDrivers(dl_phdr_info* library, size_t, void*) {
  for (const char* name : {"OSMesa", "LLVM", "gallium", "cairo", "pixman", "fontconfig", "freetype", "expat"})
    for (int i = 0; std::strstr(library->dlpi_name, name) && i < library->dlpi_phnum && driverCount < 16; ++i)
      if (const auto& part = library->dlpi_phdr[i]; part.p_type == PT_LOAD && (part.p_flags & PF_X))
        drivers[driverCount++] = {library->dlpi_addr + part.p_vaddr, library->dlpi_addr + part.p_vaddr + part.p_memsz};
  return 0;
}

/// Returns true if this request for memory must fail. `caller`: the return address.
bool noMemory(Kind kind, void* caller) {
  if (!inMain || !isCounted(kind) || isLooking) return false;
  const auto place = reinterpret_cast<std::uintptr_t>(caller);
  for (int i = 0; i < driverCount; ++i)
    if (place >= drivers[i].from && place < drivers[i].to) return false;
  if (!isHit(kind)) return false;
  errno = ENOMEM;
  return true;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

__attribute__((constructor)) void begin() { readFault(); }

}  // namespace

// Defines the C library's function `name`, which fails if `refuses` is true.
#define MORULA_FAILING(result, name, refuses, parameters, arguments) \
  result name parameters {                                           \
    static auto* const real = next<result parameters>(#name);        \
    return (refuses) ? static_cast<result>(-1) : real arguments;     \
  }
// Defines a function that writes. A short failure writes half of the bytes.
#define MORULA_WRITING(name, parameters, arguments, halfOfThem) \
  ssize_t name parameters {                                     \
    static auto* const real = next<ssize_t parameters>(#name);  \
    if (!fails(writes, to)) return real arguments;              \
    return fault.isShort && count > 1 ? real halfOfThem : -1;   \
  }
#define MORULA_OPENING(name, before, beforeArguments, folder)                                    \
  int name(before const char* path, int flags, ...) {                                            \
    va_list list;                                                                                \
    va_start(list, flags);                                                                       \
    const mode_t mode = (flags & (O_CREAT | O_TMPFILE)) ? va_arg(list, mode_t) : 0;              \
    va_end(list);                                                                                \
    static auto* const real = next<int(before const char*, int, ...)>(#name);                    \
    if (fails((flags & (O_WRONLY | O_RDWR | O_CREAT)) ? makes : reads, folder, path)) return -1; \
    return real(beforeArguments path, flags, mode);                                              \
  }
#define MORULA_NOTHING
#define MORULA_COMMA(text) text,

extern "C" {

MORULA_WRITING(write, (int to, const void* bytes, size_t count), (to, bytes, count), (to, bytes, count / 2))
MORULA_WRITING(writev, (int to, const iovec* bytes, int count), (to, bytes, count), (to, bytes, count / 2))
MORULA_WRITING(pwrite, (int to, const void* bytes, size_t count, off_t at), (to, bytes, count, at),
               (to, bytes, count / 2, at))
MORULA_WRITING(pwrite64, (int to, const void* bytes, size_t count, off64_t at), (to, bytes, count, at),
               (to, bytes, count / 2, at))
MORULA_FAILING(ssize_t, read, fails(reads, from), (int from, void* bytes, size_t count), (from, bytes, count))
MORULA_FAILING(ssize_t, pread, fails(reads, from), (int from, void* bytes, size_t count, off_t at),
               (from, bytes, count, at))
MORULA_FAILING(ssize_t, pread64, fails(reads, from), (int from, void* bytes, size_t count, off64_t at),
               (from, bytes, count, at))
MORULA_FAILING(int, fsync, fails(syncs, file), (int file), (file))
MORULA_FAILING(int, fdatasync, fails(syncs, file), (int file), (file))
MORULA_FAILING(int, ftruncate, fails(makes, file), (int file, off_t size), (file, size))
MORULA_FAILING(int, ftruncate64, fails(makes, file), (int file, off64_t size), (file, size))
MORULA_FAILING(int, mkdir, fails(makes, AT_FDCWD, path), (const char* path, mode_t mode), (path, mode))
MORULA_FAILING(int, rename, fails(renames, AT_FDCWD, to), (const char* from, const char* to), (from, to))
MORULA_FAILING(int, link, fails(renames, AT_FDCWD, to), (const char* from, const char* to), (from, to))
MORULA_FAILING(int, unlink, fails(removes, AT_FDCWD, path), (const char* path), (path))
MORULA_FAILING(int, unlinkat, fails(removes, folder, path), (int folder, const char* path, int flags),
               (folder, path, flags))
MORULA_FAILING(int, rmdir, fails(removes, AT_FDCWD, path), (const char* path), (path))
MORULA_FAILING(int, remove, fails(removes, AT_FDCWD, path), (const char* path), (path))
MORULA_OPENING(open, MORULA_NOTHING, MORULA_NOTHING, AT_FDCWD)
MORULA_OPENING(open64, MORULA_NOTHING, MORULA_NOTHING, AT_FDCWD)
MORULA_OPENING(openat, MORULA_COMMA(int folder), MORULA_COMMA(folder), folder)
MORULA_OPENING(openat64, MORULA_COMMA(int folder), MORULA_COMMA(folder), folder)

time_t time(time_t* at) {
  static auto* const real = next<time_t(time_t*)>("time");
  const char* const fast = std::getenv("FAULT_CLOCK");
  const time_t now = real(nullptr) + (fast ? std::atoi(fast) : 0);
  return at ? *at = now : now;
}

#define MORULA_CALLER __builtin_return_address(0)
void* malloc(size_t size) { return noMemory(mallocs, MORULA_CALLER) ? nullptr : __libc_malloc(size); }
void* calloc(size_t count, size_t size) {
  return noMemory(mallocs, MORULA_CALLER) ? nullptr : __libc_calloc(count, size);
}
void* realloc(void* memory, size_t size) {
  return noMemory(mallocs, MORULA_CALLER) ? nullptr : __libc_realloc(memory, size);
}
char* strdup(const char* text) {  // else the caller would be the C library
  const size_t size = std::strlen(text) + 1;
  void* const copy = noMemory(mallocs, MORULA_CALLER) ? nullptr : __libc_malloc(size);
  return copy ? static_cast<char*>(std::memcpy(copy, text, size)) : nullptr;
}
char* __strdup(const char* text) { return strdup(text); }

int __libc_start_main(int (*program)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*linkerFini)(), void* stackEnd) {
  static decltype(program) real;
  real = program;
  auto* const start = next<decltype(__libc_start_main)>("__libc_start_main");
  return start(
      [](int count, char** words, char** environment) {
        // The program loads this library only to draw; loaded early, the addresses of its code are known.
        if (isCounted(news) || isCounted(mallocs)) ::dlopen(MORULA_OSMESA, RTLD_LAZY);
        ::dl_iterate_phdr(findDrivers, nullptr);
        inMain = true;
        const int code = real(count, words, environment);
        inMain = false;
        return code;
      },
      argc, argv, init, fini, linkerFini, stackEnd);
}

}  // extern "C"

namespace {

void* newMemory(std::size_t size, std::size_t alignment, void* caller) {
  return noMemory(news, caller) ? nullptr : __libc_memalign(alignment, size ? size : 1);
}
void* orThrow(void* memory) {
  if (!memory) throw std::bad_alloc();
  return memory;
}
constexpr std::size_t usual = __STDCPP_DEFAULT_NEW_ALIGNMENT__;

}  // namespace

void* operator new(std::size_t size) { return orThrow(newMemory(size, usual, MORULA_CALLER)); }
void* operator new[](std::size_t size) { return orThrow(newMemory(size, usual, MORULA_CALLER)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return newMemory(size, usual, MORULA_CALLER); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return newMemory(size, usual, MORULA_CALLER); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return orThrow(newMemory(size, static_cast<std::size_t>(alignment), MORULA_CALLER));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return orThrow(newMemory(size, static_cast<std::size_t>(alignment), MORULA_CALLER));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }
