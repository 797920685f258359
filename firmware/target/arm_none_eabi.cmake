# Toolchain: GNU for bare-metal Arm, Cortex-M4 with its single-precision floating-point unit.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)

set(gaitway_cpu "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
# No fused multiply-add: the target computes the same bits as every other machine.
set(CMAKE_CXX_FLAGS_INIT "${gaitway_cpu} -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics \
-fno-unwind-tables -fno-asynchronous-unwind-tables -ffp-contract=off -ffunction-sections -fdata-sections")
# The memory routines of newlib and the arithmetic of libgcc, nothing else: what wants a heap, exceptions or an operating
# system does not link.
set(CMAKE_EXE_LINKER_FLAGS_INIT "${gaitway_cpu} -nostdlib -nostartfiles -Wl,--gc-sections -Wl,--fatal-warnings")
set(CMAKE_CXX_STANDARD_LIBRARIES "-lc_nano -lgcc")
