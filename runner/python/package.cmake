# The Python package, in the build folder's `python`: the compiled module beside the package's sources. It is built on
# request (../morula python), by the test that needs it, and for packages. Python_EXECUTABLE names the interpreter; by
# default it is the system's, for which the system's packages are.
if(NOT Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
set(needed QUIET)
if(MORULA_PYTHON)
  set(needed REQUIRED)
endif()
find_package(Python 3.9 ${needed} COMPONENTS Interpreter Development.Module)
find_package(pybind11 2.10 CONFIG ${needed})
if(NOT pybind11_FOUND OR NOT Python_Development.Module_FOUND)
  return()
endif()
set(MORULA_PYTHON_PROGRAM ${Python_EXECUTABLE} CACHE INTERNAL "the interpreter of the Python package")
set(package ${CMAKE_BINARY_DIR}/python/morula)
set(about ${CMAKE_BINARY_DIR}/python/morula-${PROJECT_VERSION}.dist-info)
pybind11_add_module(morula_python MODULE NO_EXTRAS EXCLUDE_FROM_ALL python/module.cpp python/organism.cpp)
target_include_directories(morula_python PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
target_link_libraries(morula_python PRIVATE runner_views runner_reader)
target_compile_options(morula_python PRIVATE "$<$<CONFIG:Release>:-O1>" "${MORULA_PRECOMPILED}")
target_link_options(morula_python PRIVATE -Wl,--as-needed -Wl,--exclude-libs,ALL)
set_target_properties(morula_python PROPERTIES OUTPUT_NAME _morula LIBRARY_OUTPUT_DIRECTORY ${package} UNITY_BUILD OFF)
file(GLOB sources CONFIGURE_DEPENDS python/morula/*)
add_custom_command(OUTPUT ${package}/_morula.pyi ${about}/WHEEL
  COMMAND ${CMAKE_COMMAND} -E copy ${sources} ${package}
  COMMAND ${Python_EXECUTABLE} -B ${CMAKE_CURRENT_SOURCE_DIR}/python/describe.py ${package} ${about} ${CMAKE_CURRENT_SOURCE_DIR}/python/pyproject.toml
  DEPENDS morula_python ${sources} python/describe.py ${CMAKE_CURRENT_SOURCE_DIR}/python/pyproject.toml VERBATIM)
add_custom_target(python-module DEPENDS ${package}/_morula.pyi ${about}/WHEEL)
add_custom_target(python-package)  # with the program, which the plugin for pytest starts
add_dependencies(python-package python-module morula)
install(TARGETS morula_python LIBRARY DESTINATION morula COMPONENT python EXCLUDE_FROM_ALL)  # for scikit-build-core
