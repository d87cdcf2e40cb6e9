# The simulator as WebAssembly, by Debian's emscripten (3.1, with clang 14 and libc++ 13).
#
#   cmake --toolchain core/wasm/toolchain.cmake -DMORULA_CORE_ONLY=ON -DMORULA_THREADS=OFF …
#
# Programs are JavaScript with the module beside it; Node.js runs them, and they see its files.
set(EMSCRIPTEN_ROOT_PATH /usr/share/emscripten CACHE PATH "Where emscripten lies")
set(EMSCRIPTEN_SYSTEM_PROCESSOR wasm32)
include(${EMSCRIPTEN_ROOT_PATH}/cmake/Modules/Platform/Emscripten.cmake)
# What it runs in Node.js while it links is in Debian's place, where Node.js from elsewhere does not look.
set(CMAKE_CXX_LINKER_LAUNCHER ${CMAKE_COMMAND} -E env NODE_PATH=/usr/share/nodejs)

# Libraries of headers only are this machine's: not all of /usr/include, whose C library is another one.
set(headers ${CMAKE_BINARY_DIR}/headers)
file(MAKE_DIRECTORY ${headers})
foreach(library Random123 xxhash.h xxh3.h)
  file(CREATE_LINK /usr/include/${library} ${headers}/${library} SYMBOLIC)
endforeach()
set(Eigen3_DIR /usr/share/eigen3/cmake CACHE PATH "Where Eigen's package file lies")

# Random123 refuses machines that it does not know by name; for RISC-V it compiles what it compiles for any other.
add_compile_options(-fwasm-exceptions -D__riscv "SHELL:-isystem ${CMAKE_CURRENT_LIST_DIR}/standard" "SHELL:-isystem ${headers}")
add_link_options(-fwasm-exceptions "SHELL:-s ALLOW_MEMORY_GROWTH=1 -s MAXIMUM_MEMORY=4GB")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-s ENVIRONMENT=node -s NODERAWFS=1 -s WASM_ASYNC_COMPILATION=0 -s EXIT_RUNTIME=1")
