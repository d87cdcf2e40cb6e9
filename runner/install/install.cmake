# What is installed beside the library, and packages of it. Without the explorer or the simulator for pages, which are built on request
# (./morula package does), pages come without them.
set(share ${CMAKE_INSTALL_DATADIR}/morula)
set(built ${CMAKE_BINARY_DIR}/install)
file(MAKE_DIRECTORY ${built})
install(TARGETS morula RUNTIME)
install(DIRECTORY scenarios golden DESTINATION ${share})
foreach(program explorer rerun playground)
  install(FILES ${CMAKE_BINARY_DIR}/explorer/${program}.js DESTINATION ${share}/explorer OPTIONAL)
endforeach()
install(FILES ${CMAKE_BINARY_DIR}/wasm/morula.wasm.gz ${CMAKE_BINARY_DIR}/wasm/playground.wasm.gz DESTINATION ${share}/wasm OPTIONAL)

# What the program says of its own command line.
install(CODE "
  foreach(form bash zsh fish man)
    execute_process(COMMAND $<TARGET_FILE:morula> internal describe \${form} OUTPUT_FILE ${built}/morula.\${form} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  execute_process(COMMAND gzip -9nc ${built}/morula.man OUTPUT_FILE ${built}/morula.1.gz COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND gzip -9nc ${CMAKE_CURRENT_LIST_DIR}/changelog OUTPUT_FILE ${built}/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
")
install(FILES ${built}/morula.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${built}/morula.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME morula)
install(FILES ${built}/morula.zsh DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions RENAME _morula)
install(FILES ${built}/morula.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md CITATION.cff ${built}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY tests/install/example DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples)

# cpack: morula_VERSION_ARCHITECTURE.deb and morula-VERSION-ARCHITECTURE.tar.gz
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME morula)
set(CPACK_PACKAGE_CONTACT "The Morula authors <authors@morula.org.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "simulator of dividing cells, the same bits on any machine")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Morula grows small organisms out of one cell: genes decide what each cell
does, and a simulation of soft bodies decides where it lies. Each scenario is
one file, each run is stored with its provenance and checked, and the same
scenario gives the same bits on any machine.")
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_FILE_NAME morula-${PROJECT_VERSION}-${CMAKE_SYSTEM_PROCESSOR})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # what the program is linked with
set(CPACK_DEBIAN_PACKAGE_DEPENDS libosmesa6)  # what it loads to draw
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS fonts-dejavu-core)  # words in pictures and charts
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, g++, cmake, libtbb-dev")  # films; the library in programs of others
include(CPack)
