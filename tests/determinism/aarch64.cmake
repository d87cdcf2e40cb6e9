# Another architecture, run by emulation: Debian's g++-aarch64-linux-gnu and qemu-user.
#
#   cmake --toolchain aarch64.cmake -DMORULA_THREADS=OFF …
#
# No threads, for oneTBB is not there for the other architecture. Libraries that are headers only (Eigen, Random123,
# xxHash) are this machine's: Debian's cross compilers look into /usr/include, last. Static, so that the emulator needs
# no libraries either.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
