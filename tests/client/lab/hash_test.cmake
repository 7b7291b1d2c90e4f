# `poolhall-lab hash` prints the committed hashes.
execute_process(COMMAND ${PROGRAM} hash OUTPUT_VARIABLE actual RESULT_VARIABLE status)
file(READ ${EXPECTED} expected)
if(NOT status EQUAL 0 OR NOT actual STREQUAL expected)
    message(FATAL_ERROR "status ${status}, printed\n${actual}expected\n${expected}")
endif()
