# The cases of cases/*.yaml as a C array, so that `stiffaxis example NAME` needs no files beside the program.
# Included: embed_cases(room) adds the array to a room. As a script: cmake -DCASES=a.yaml|b.yaml -DOUT=examples.c -P embed.cmake

if(CMAKE_SCRIPT_MODE_FILE)
    string(REPLACE "|" ";" CASES "${CASES}")
    set(texts "")
    set(table "")
    set(number 0)
    foreach(case ${CASES})
        get_filename_component(name ${case} NAME_WE)
        file(READ ${case} hex HEX)
        string(LENGTH "${hex}" length)
        math(EXPR length "${length} / 2")
        string(REGEX REPLACE "([0-9a-f][0-9a-f])" "'\\\\x\\1'," bytes "${hex}")
        string(APPEND texts "static const char text_${number}[] = {${bytes} '\\0'};\n")
        string(APPEND table "    {\"${name}\", text_${number}, ${length}},\n")
        math(EXPR number "${number} + 1")
    endforeach()
    file(WRITE ${OUT} "#include \"app/examples.h\"\n\n${texts}\nconst example examples[] = {\n${table}    {0},\n};\n")
    return()
endif()

set(EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(embed_cases room)
    file(GLOB cases CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/cases/*.yaml)
    string(REPLACE ";" "|" joined "${cases}")
    set(out ${CMAKE_BINARY_DIR}/examples.c)
    add_custom_command(OUTPUT ${out}
        COMMAND ${CMAKE_COMMAND} "-DCASES=${joined}" -DOUT=${out} -P ${EMBED_SCRIPT}
        DEPENDS ${cases} ${EMBED_SCRIPT} VERBATIM COMMENT "cases as a C array")
    target_sources(${room} PRIVATE ${out})
endfunction()
