# What `cmake --install` puts below the prefix, and what of it the program makes itself. Nothing there knows the prefix: the program
# finds its modules from its own place. Components: program, doc; the C libraries bring their own.
include(GNUInstallDirs)

set(MODULES lib/stiffaxis) # nobody's but ours, and the same place everywhere
file(RELATIVE_PATH modules_from_bin /${CMAKE_INSTALL_BINDIR} /${MODULES})
set(CMAKE_INSTALL_RPATH "$ORIGIN:$ORIGIN/${modules_from_bin}")

# written_by_program(FILE DESTINATION COMPONENT arguments...): FILE in the build directory's share/ holds what the program prints
function(written_by_program file destination component)
    set(out ${CMAKE_BINARY_DIR}/share/${file})
    add_custom_command(OUTPUT ${out} COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/share
        COMMAND stiffaxis ${ARGN} > ${out} DEPENDS stiffaxis VERBATIM COMMENT "share/${file}")
    set_property(GLOBAL APPEND PROPERTY written ${out})
    install(FILES ${out} DESTINATION ${destination} COMPONENT ${component})
endfunction()

function(installation)
    set(doors door_hdf5 door_gmsh door_petsc door_gsl door_embree door_nlopt door_mpi)
    install(TARGETS stiffaxis RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
    install(TARGETS base ${doors} LIBRARY DESTINATION ${MODULES} COMPONENT program)

    set(share ${CMAKE_INSTALL_DATADIR})
    written_by_program(stiffaxis.1 ${CMAKE_INSTALL_MANDIR}/man1 program man)
    written_by_program(stiffaxis-case.5 ${CMAKE_INSTALL_MANDIR}/man5 program man case)
    written_by_program(stiffaxis ${share}/bash-completion/completions program completion bash)
    written_by_program(_stiffaxis ${share}/zsh/site-functions program completion zsh)
    written_by_program(stiffaxis.fish ${share}/fish/vendor_completions.d program completion fish)
    written_by_program(stiffaxis.schema.json ${share}/stiffaxis program schema)
    written_by_program(keys.md ${CMAKE_INSTALL_DOCDIR}/docs doc schema --markdown)

    # as in the repository, so that the links from one to another hold
    install(FILES README.md CHANGELOG.md CITATION.cff LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
    install(DIRECTORY docs examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc)
    install(DIRECTORY cases DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT doc
        PATTERN "*.stl" EXCLUDE PATTERN "targets.csv" EXCLUDE PATTERN "entry.csv" EXCLUDE)

    # all that is installed, without the tests
    get_property(written GLOBAL PROPERTY written)
    get_property(libraries GLOBAL PROPERTY c_libraries)
    add_custom_target(share ALL DEPENDS ${written})
    add_custom_target(product DEPENDS share stiffaxis base ${doors} ${libraries})
endfunction()
