# SPDX-License-Identifier: MIT
# bolan_embed(target name header folder pattern): puts the text files of a folder into the target as a table
#     const struct <name> { const char *path; const char *text; } <name>s[]; const unsigned <name>_count;
# that src/.../<header> declares. Paths are relative to the folder and sorted.

function(bolan_embed target name header folder pattern)
    file(GLOB_RECURSE files RELATIVE ${PROJECT_SOURCE_DIR}/${folder} CONFIGURE_DEPENDS
        ${PROJECT_SOURCE_DIR}/${folder}/${pattern})
    list(SORT files)
    list(TRANSFORM files PREPEND ${PROJECT_SOURCE_DIR}/${folder}/ OUTPUT_VARIABLE paths)
    set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded/${name}.c)
    string(REGEX REPLACE "^src/" "" include ${header})
    list(JOIN files "|" joined)
    add_custom_command(OUTPUT ${output}
        COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DHEADER=${include} -DFOLDER=${PROJECT_SOURCE_DIR}/${folder}
            "-DFILES=${joined}" -DOUTPUT=${output} -P ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
        DEPENDS ${paths} ${PROJECT_SOURCE_DIR}/cmake/embed_text.cmake
        COMMENT "Embedding ${folder}/" VERBATIM)
    # A text may be longer than the 4095 characters that C17 promises for a literal; every compiler we build with takes it.
    set_source_files_properties(${output} PROPERTIES COMPILE_OPTIONS -Wno-overlength-strings)
    target_sources(${target} PRIVATE ${output})
endfunction()
