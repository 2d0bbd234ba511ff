# SPDX-License-Identifier: MIT
# tests/web: compiles the page by emscripten and opens it in a headless Chromium.
if(BOLAN_PYTHON3)
    add_test(NAME web/page COMMAND sh ${test_folder}/web/run.sh)
    set_tests_properties(web/page PROPERTIES LABELS web TIMEOUT 900 SKIP_RETURN_CODE 77 PROCESSORS 2 COST 2000
        ENVIRONMENT "${python_environment};BOLAN_PYTHON3=${BOLAN_PYTHON3}")
endif()
