# SPDX-License-Identifier: MIT
# The manual page and the completions of bash, zsh and fish: the program prints them from its own tables.
set(manual_folder ${CMAKE_BINARY_DIR}/share)
# name of the file, where it is installed below share/, and what the program is asked for
set(manual_files
    "bolan.1:man/man1:--man"
    "bolan:bash-completion/completions:--completion bash"
    "_bolan:zsh/site-functions:--completion zsh"
    "bolan.fish:fish/vendor_completions.d:--completion fish")

# A program of another machine cannot be asked, and one with a sanitizer is not installed.
if(NOT CMAKE_CROSSCOMPILING AND NOT BOLAN_SANITIZE AND NOT BOLAN_FUZZ)
    set(manual_outputs "")
    foreach(entry IN LISTS manual_files)
        string(REPLACE ":" ";" entry "${entry}")
        list(GET entry 0 name)
        list(GET entry 1 folder)
        list(GET entry 2 arguments)
        separate_arguments(arguments UNIX_COMMAND "${arguments}")
        set(output ${manual_folder}/${folder}/${name})
        file(MAKE_DIRECTORY ${manual_folder}/${folder})
        add_custom_command(OUTPUT ${output} COMMAND bolan_cli info ${arguments} > ${output} DEPENDS bolan_cli
            COMMENT "Writing ${name}" VERBATIM)
        list(APPEND manual_outputs ${output})
        if(BOLAN_INSTALL)
            install(FILES ${output} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT program)
        endif()
    endforeach()
    add_custom_target(bolan_manual ALL DEPENDS ${manual_outputs})
endif()
