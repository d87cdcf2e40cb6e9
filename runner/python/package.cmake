# The Python package, in the build folder's `python`: the compiled module beside the sources of the package. PYTHON names the
# interpreter (-D Python_EXECUTABLE=…).
find_package(Python 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG REQUIRED)
pybind11_add_module(morula_python MODULE NO_EXTRAS python/module.cpp python/organism.cpp)
target_include_directories(morula_python PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(morula_python PRIVATE runner_views runner_reader)
target_compile_options(morula_python PRIVATE "$<$<CONFIG:Release>:-O1>" "${MORULA_PRECOMPILED}")
target_link_options(morula_python PRIVATE -Wl,--as-needed -Wl,--exclude-libs,ALL)
set(package ${CMAKE_BINARY_DIR}/python/morula)
set_target_properties(morula_python PROPERTIES OUTPUT_NAME _morula LIBRARY_OUTPUT_DIRECTORY ${package} UNITY_BUILD OFF)
file(GLOB sources CONFIGURE_DEPENDS python/morula/*)
add_custom_command(TARGET morula_python POST_BUILD
  COMMAND ${CMAKE_COMMAND} -E copy ${sources} ${package}
  COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${CMAKE_BINARY_DIR}/python ${Python_EXECUTABLE} ${CMAKE_CURRENT_SOURCE_DIR}/python/stubs.py ${package})
