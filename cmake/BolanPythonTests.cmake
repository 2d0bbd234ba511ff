# SPDX-License-Identifier: MIT
# tests/python/test_*.py by pytest, and the examples of the Python package. Debian's python3, which has cffi and numpy.
find_program(BOLAN_PYTHON3 python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(BOLAN_PYTHON3 python3)
file(GLOB python_tests CONFIGURE_DEPENDS ${test_folder}/python/test_*.py)
set(python_environment "BOLAN_LIBRARY=$<TARGET_FILE:bolan_all>;BOLAN_SOURCE_DIR=${PROJECT_SOURCE_DIR}"
    "PYTHONPATH=${PROJECT_SOURCE_DIR}/bindings/python;PYTHONDONTWRITEBYTECODE=1;CC=${CMAKE_C_COMPILER}")
if(TARGET bolan_cli)
    list(APPEND python_environment "BOLAN=$<TARGET_FILE:bolan_cli>")
endif()
if(BOLAN_PYTHON3)
    foreach(file IN LISTS python_tests)
        get_filename_component(name ${file} NAME_WE)
        add_test(NAME python/${name} COMMAND sh ${PROJECT_SOURCE_DIR}/tools/in_scratch.sh
            ${CMAKE_BINARY_DIR}/tests/python/${name} ${BOLAN_PYTHON3} ${test_folder}/python/run.py ${name}.py)
        set_tests_properties(python/${name} PROPERTIES LABELS python TIMEOUT 900 SKIP_RETURN_CODE 77
            ENVIRONMENT "${python_environment}")
    endforeach()
endif()
