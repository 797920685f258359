# Prints how much flash and RAM the joint's firmware takes, and writes it to size.txt: flash holds code, constants and the
# first values of variables; RAM holds the variables, without the stack.
execute_process(COMMAND "${SIZE}" --format=berkeley "${BUILD}/gaitway_joint.elf" OUTPUT_VARIABLE sizes COMMAND_ERROR_IS_FATAL ANY)
if(NOT sizes MATCHES "\n *([0-9]+)[ \t]+([0-9]+)[ \t]+([0-9]+)[ \t]")
  message(FATAL_ERROR "${SIZE} said: ${sizes}")
endif()
math(EXPR flash "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")
math(EXPR ram "${CMAKE_MATCH_2} + ${CMAKE_MATCH_3}")
set(line "joint firmware, Cortex-M4: ${flash} bytes of flash, ${ram} bytes of RAM without the stack")
file(WRITE "${BUILD}/size.txt" "${line}\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -E echo "${line}")
