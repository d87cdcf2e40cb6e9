# Toolchain for another architecture, run by emulation: Debian's g++-aarch64-linux-gnu and qemu-user.
#
#   cmake --toolchain aarch64.cmake -DMORULA_THREADS=OFF …
#
# Threads are off, because oneTBB is missing for this architecture. Header-only libraries (Eigen, Random123, xxHash)
# come from /usr/include, where Debian's cross compilers look last. Programs are static, so that the emulator needs no
# libraries.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
