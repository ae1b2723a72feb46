# The page's scripts inside the program: three.js as Debian ships it, and reports/view*.js; and how to cite it. The assembler
# takes the bytes in; their SHA-256 is what the page's content-security policy lets run.
# Included: embed_scripts(room). As a script: cmake -DTHREE=three.min.js -DGZIP=gzip -DVIEW_ROOM=reports
# -DVIEW=joined.js -DCITATION=CITATION.cff -DOUT=scripts.c -P scripts.cmake

set(VIEW_FILES view_inflate.js view_shapes.js view_bodies.js view.js view_controls.js view_hands.js) # in this order

if(CMAKE_SCRIPT_MODE_FILE)
    # the view's files are one script, which leaves no name behind
    set(joined "\"use strict\";\n(function () {\n")
    foreach(file ${VIEW_FILES})
        file(READ ${VIEW_ROOM}/${file} text)
        string(APPEND joined "${text}")
    endforeach()
    file(WRITE ${VIEW} "${joined}})();\n")
    set(source "#include \"reports/scripts.h\"\n")
    foreach(name three view citation)
        string(TOUPPER ${name} upper)
        set(file "${${upper}}")
        file(SHA256 ${file} hash)
        string(REGEX REPLACE "(..)" "0x\\1, " hash ${hash})
        file(READ ${file} text)
        # what the browser's parser would change, the hash would not know of
        if(name STREQUAL "view" AND text MATCHES "\r|</script|<!--")
            message(FATAL_ERROR "${file} cannot stand in a page as it is: a carriage return, </script or <!-- in it")
        endif()
        # three.js is packed; its hash stays that of what comes out of it
        if(name STREQUAL "three")
            string(REGEX MATCH "REVISION ?= ?[\"']([0-9]+)" revision "${text}")
            string(APPEND source "const char three_revision[] = \"${CMAKE_MATCH_1}\";\n")
            execute_process(COMMAND ${GZIP} -9nc ${file} OUTPUT_FILE ${OUT}.three.gz COMMAND_ERROR_IS_FATAL ANY)
            set(file ${OUT}.three.gz)
        endif()
        string(APPEND source "
__asm__(\".pushsection .rodata\\n\"
        \".global stiffaxis_${name}\\n\"
        \".global stiffaxis_${name}_end\\n\"
        \"stiffaxis_${name}: .incbin \\\"${file}\\\"\\n\"
        \"stiffaxis_${name}_end: .byte 0\\n\"
        \".popsection\\n\");
extern const char stiffaxis_${name}[], stiffaxis_${name}_end[];
const script script_${name} = {stiffaxis_${name}, stiffaxis_${name}_end, {${hash}}};
")
    endforeach()
    file(WRITE ${OUT} "${source}")
    return()
endif()

set(SCRIPTS_SCRIPT ${CMAKE_CURRENT_LIST_FILE})

function(embed_scripts room)
    find_file(THREE_JS three.min.js PATHS /usr/share/javascript/three PATH_SUFFIXES build NO_DEFAULT_PATH)
    if(NOT THREE_JS)
        message(FATAL_ERROR "three.min.js is not there: install Debian's libjs-three (all packages stand in packages.txt), "
            "or give its place with -DTHREE_JS=FILE")
    endif()
    find_program(GZIP gzip REQUIRED)
    set(out ${CMAKE_BINARY_DIR}/scripts.c)
    set(view ${CMAKE_BINARY_DIR}/view.js)
    set(citation ${PROJECT_SOURCE_DIR}/CITATION.cff)
    list(TRANSFORM VIEW_FILES PREPEND ${PROJECT_SOURCE_DIR}/reports/ OUTPUT_VARIABLE parts)
    add_custom_command(OUTPUT ${out}
        COMMAND ${CMAKE_COMMAND} -DTHREE=${THREE_JS} -DGZIP=${GZIP} -DVIEW_ROOM=${PROJECT_SOURCE_DIR}/reports -DVIEW=${view}
            -DCITATION=${citation} -DOUT=${out} -P ${SCRIPTS_SCRIPT}
        DEPENDS ${THREE_JS} ${parts} ${citation} ${SCRIPTS_SCRIPT} VERBATIM COMMENT "the page's scripts")
    set_source_files_properties(${out} PROPERTIES OBJECT_DEPENDS "${THREE_JS};${parts};${citation}")
    target_sources(${room} PRIVATE ${out})
endfunction()
