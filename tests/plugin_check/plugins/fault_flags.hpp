// One constant a fault, true in the one library that has it. Included by misbehaving.cpp alone.
#pragma once

#ifdef GAITWAY_FAULT_leaks_memory
constexpr bool leaks_memory = true;
#else
constexpr bool leaks_memory = false;
#endif
#ifdef GAITWAY_FAULT_leaks_descriptor
constexpr bool leaks_descriptor = true;
#else
constexpr bool leaks_descriptor = false;
#endif
#ifdef GAITWAY_FAULT_starts_thread
constexpr bool starts_thread = true;
#else
constexpr bool starts_thread = false;
#endif
#ifdef GAITWAY_FAULT_shares_static
constexpr bool shares_static = true;
#else
constexpr bool shares_static = false;
#endif
#ifdef GAITWAY_FAULT_depends_on_address
constexpr bool depends_on_address = true;
#else
constexpr bool depends_on_address = false;
#endif
#ifdef GAITWAY_FAULT_depends_on_uninitialised
constexpr bool depends_on_uninitialised = true;
#else
constexpr bool depends_on_uninitialised = false;
#endif
#ifdef GAITWAY_FAULT_depends_on_time
constexpr bool depends_on_time = true;
#else
constexpr bool depends_on_time = false;
#endif
#ifdef GAITWAY_FAULT_allocates
constexpr bool allocates = true;
#else
constexpr bool allocates = false;
#endif
#ifdef GAITWAY_FAULT_locks
constexpr bool locks = true;
#else
constexpr bool locks = false;
#endif
#ifdef GAITWAY_FAULT_calls_system
constexpr bool calls_system = true;
#else
constexpr bool calls_system = false;
#endif
#ifdef GAITWAY_FAULT_throws_in_step
constexpr bool throws_in_step = true;
#else
constexpr bool throws_in_step = false;
#endif
#ifdef GAITWAY_FAULT_too_slow
constexpr bool too_slow = true;
#else
constexpr bool too_slow = false;
#endif
#ifdef GAITWAY_FAULT_publishes_nan
constexpr bool publishes_nan = true;
#else
constexpr bool publishes_nan = false;
#endif
#ifdef GAITWAY_FAULT_out_of_range
constexpr bool out_of_range = true;
#else
constexpr bool out_of_range = false;
#endif
#ifdef GAITWAY_FAULT_jumps
constexpr bool jumps = true;
#else
constexpr bool jumps = false;
#endif
#ifdef GAITWAY_FAULT_crashes_on_missing_input
constexpr bool crashes_on_missing_input = true;
#else
constexpr bool crashes_on_missing_input = false;
#endif
#ifdef GAITWAY_FAULT_crashes_on_joint_count
constexpr bool crashes_on_joint_count = true;
#else
constexpr bool crashes_on_joint_count = false;
#endif
#ifdef GAITWAY_FAULT_publishes_nan_on_nan
constexpr bool publishes_nan_on_nan = true;
#else
constexpr bool publishes_nan_on_nan = false;
#endif
#ifdef GAITWAY_FAULT_never_recovers
constexpr bool never_recovers = true;
#else
constexpr bool never_recovers = false;
#endif
#ifdef GAITWAY_FAULT_crashes_on_destroy_without_activate
constexpr bool crashes_on_destroy_without_activate = true;
#else
constexpr bool crashes_on_destroy_without_activate = false;
#endif
#ifdef GAITWAY_FAULT_crashes_on_second_activate
constexpr bool crashes_on_second_activate = true;
#else
constexpr bool crashes_on_second_activate = false;
#endif
#ifdef GAITWAY_FAULT_keeps_memory_on_refusal
constexpr bool keeps_memory_on_refusal = true;
#else
constexpr bool keeps_memory_on_refusal = false;
#endif
#ifdef GAITWAY_FAULT_crashes_on_parameter
constexpr bool crashes_on_parameter = true;
#else
constexpr bool crashes_on_parameter = false;
#endif
#ifdef GAITWAY_FAULT_hangs_on_parameter
constexpr bool hangs_on_parameter = true;
#else
constexpr bool hangs_on_parameter = false;
#endif
#ifdef GAITWAY_FAULT_nan_on_parameter
constexpr bool nan_on_parameter = true;
#else
constexpr bool nan_on_parameter = false;
#endif
#ifdef GAITWAY_FAULT_crashes_on_live_change
constexpr bool crashes_on_live_change = true;
#else
constexpr bool crashes_on_live_change = false;
#endif
#ifdef GAITWAY_FAULT_hangs_in_create
constexpr bool hangs_in_create = true;
#else
constexpr bool hangs_in_create = false;
#endif
#ifdef GAITWAY_FAULT_fails_in_create
constexpr bool fails_in_create = true;
#else
constexpr bool fails_in_create = false;
#endif
#ifdef GAITWAY_FAULT_forgets_state
constexpr bool forgets_state = true;
#else
constexpr bool forgets_state = false;
#endif
#ifdef GAITWAY_FAULT_wrong_state_size
constexpr bool wrong_state_size = true;
#else
constexpr bool wrong_state_size = false;
#endif
#ifdef GAITWAY_FAULT_takes_any_state
constexpr bool takes_any_state = true;
#else
constexpr bool takes_any_state = false;
#endif
#ifdef GAITWAY_FAULT_bad_version
constexpr bool bad_version = true;
#else
constexpr bool bad_version = false;
#endif
#ifdef GAITWAY_FAULT_bad_default
constexpr bool bad_default = true;
#else
constexpr bool bad_default = false;
#endif
