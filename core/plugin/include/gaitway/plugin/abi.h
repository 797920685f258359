/* The border between main controller and plug-in: plain C, versioned. C++ authors use plugin.hpp on top of
 * it.
 *
 * Rules. A plug-in library shows one symbol, the constant `gaitway_plugin_entry`. The host compares its ABI
 * number and struct sizes with its own before it calls anything. No exception and no C++ type crosses, and
 * nothing that one side allocated is freed by the other. Texts are UTF-8 and end in NUL; a text that is
 * passed in lives at least as long as the call.
 *
 * Versions. A plug-in of the same major and of the same or a lower minor number is loaded. Within a major
 * number no function and no member moves: a minor number adds extensions, constants, or members at a struct's
 * end. What is optional is an extension: a constant table of functions, asked for by name and version with
 * get_extension, in both directions. A table never changes under its name; its successor is "name/2".
 *
 * Life of an instance:
 *   create -> activate -> step ... step -> deactivate -> (activate ... | destroy)
 * Before the first step restore_state may be called once, after activate; between two steps save_state and
 * set_parameter.
 *
 * Threads. Each function says which thread calls it:
 *   [set-up]  one of ordinary priority: that which starts the main controller, and for changes while the
 *             robot walks another one beside the ticks. May allocate, read files and take its time.
 *   [tick]    that of the ticks. May not allocate, lock or make system calls.
 *   [caller]  that which is in a call of this instance at the time; the [tick] rules hold.
 *   [any]     any thread, also one of the plug-in's own, at any time between create's begin and destroy's
 *             return, several at once. Does not allocate, lock or make system calls.
 * [set-up] and [tick] calls of one instance never overlap, and each sees what the one before it wrote. */
#ifndef GAITWAY_PLUGIN_ABI_H
#define GAITWAY_PLUGIN_ABI_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define GAITWAY_PLUGIN_MAGIC 0x4757504cu /* "GWPL" */
#define GAITWAY_PLUGIN_ABI 5u            /* major: grows when something below changes */
#define GAITWAY_PLUGIN_ABI_MINOR 0u      /* grows when something is added, see Versions above */

/* What every callback answers. Negative: it failed, and the error text says why. */
typedef int32_t gaitway_status;
enum { GAITWAY_OK = 0, GAITWAY_NO_VALUE = 1, GAITWAY_FAILED = -1 };

/* Room for an error text, owned by the caller. Whoever fails writes at most `capacity` bytes, NUL included.
 */
typedef struct gaitway_text {
  char* data;
  uint32_t capacity;
  uint32_t reserved;
} gaitway_text;

typedef struct gaitway_tick {
  int64_t now_ns;          /* clock of the robot, virtual or real */
  int64_t batch_start_ns;  /* when the next batch will start to play */
  uint32_t batch_sequence; /* its sequence number = cycle number */
  uint32_t tick;           /* ticks of 10 ms since start */
  uint32_t batch;          /* 1: this tick prepares that batch (every eighth) */
  uint32_t reserved;
} gaitway_tick;

/* How a plug-in uses a topic. */
typedef uint32_t gaitway_access;
enum {
  GAITWAY_READ =
      0, /* value of this tick: the plug-in is stepped after the topic's writer, which must exist */
  GAITWAY_READ_PREVIOUS = 1, /* value of the tick before: no order, breaks a cycle; the writer must exist */
  GAITWAY_READ_OPTIONAL = 2, /* like GAITWAY_READ; a missing writer is no error */
  GAITWAY_WRITE = 3,         /* the topic's only writer */
  GAITWAY_READ_PREVIOUS_OPTIONAL = 4 /* like GAITWAY_READ_PREVIOUS; a missing writer is no error */
};

/* A run of floating-point numbers in a topic's value; the host refuses to publish one that is not finite or
 * lies beyond the limits. */
typedef struct gaitway_float_field {
  const char* name;
  uint32_t offset;        /* bytes from the start of the value */
  uint32_t count;         /* numbers */
  uint32_t bytes;         /* of a number: 4 or 8 */
  uint32_t rows;          /* first extent of an array, 1 for a scalar: divides `count` */
  double lowest, highest; /* what is allowed; both 0: whatever is finite */
} gaitway_float_field;

typedef struct gaitway_topic {
  const char* name;
  const char* type_name;
  uint64_t type_hash;
  uint32_t size;              /* bytes of a value */
  uint32_t float_field_count; /* may be 0; a standard topic is checked all the same */
  const gaitway_float_field* float_fields;
} gaitway_topic;

/* Which value a reader holds. Zeroed at first, then given back as it was. */
typedef struct gaitway_sample {
  uint64_t sequence; /* 1 for a topic's first value; 0: none yet */
  int64_t stamp_ns;  /* tick at which it was published; of topics from elsewhere, what their writer says */
} gaitway_sample;

/* What a parameter holds. */
typedef uint32_t gaitway_kind;
enum { GAITWAY_NUMBER = 0, GAITWAY_INTEGER = 1, GAITWAY_FLAG = 2, GAITWAY_TEXT = 3 };

typedef struct gaitway_value {
  gaitway_kind kind;
  uint32_t reserved;
  double number;
  int64_t integer;  /* of a flag 0 or 1 */
  const char* text; /* of a value that the host gives: belongs to the host, lives until destroy returns */
} gaitway_value;

typedef struct gaitway_parameter {
  const char* name;
  const char* unit; /* "1": a plain number; flags and texts have none */
  const char* doc;  /* one line for people; may be empty */
  gaitway_value fallback;
  double lowest, highest; /* what is allowed; of flags and texts without meaning */
  uint32_t live;          /* 1: may be changed between two steps, then set_parameter is called */
  uint32_t reserved;
} gaitway_parameter;

typedef uint32_t gaitway_period;
enum { GAITWAY_EVERY_TICK = 0, GAITWAY_EVERY_BATCH = 1 };

typedef uint32_t gaitway_severity;
enum { GAITWAY_INFO = 0, GAITWAY_WARNING = 1, GAITWAY_ERROR = 2 };

typedef struct gaitway_port gaitway_port; /* a topic that was opened; belongs to the host */

/* What the host offers. Valid from create to the return of destroy; `context` goes into every call. */
typedef struct gaitway_host {
  void* context;

  /* [set-up] In create only. The topic is bound once all plug-ins were created and their data flow was
   * checked, so it has no value before activate. */
  gaitway_status (*open_topic)(void* context, const gaitway_topic* topic, gaitway_access access,
                               gaitway_port** port, const gaitway_text* error);
  /* [set-up] In create only. Declares a parameter and gives the configuration's value, or the default. Fails
   * for a value of another kind or unit, or out of range. */
  gaitway_status (*parameter)(void* context, const gaitway_parameter* parameter, gaitway_value* value,
                              const gaitway_text* error);
  /* [set-up] In create only. Default: every tick. */
  gaitway_status (*set_period)(void* context, gaitway_period period, const gaitway_text* error);
  /* [any] Folder of the robot's description; belongs to the host and lives until destroy returns. */
  const char* (*robot_directory)(void* context);

  /* [caller] In activate, step and deactivate. If the port's value is newer than `sample`, copies it into
   * `value` (the topic's size) and updates `sample`; else touches neither. GAITWAY_OK: `value` holds a value.
   * GAITWAY_NO_VALUE: there has never been one. GAITWAY_FAILED: the port is none to read, or not bound yet.
   */
  gaitway_status (*read)(void* context, gaitway_port* port, void* value, gaitway_sample* sample);
  /* [tick] In step only. Copies `value`; the last one of a step goes out when that step has returned
   * GAITWAY_OK, and is thrown away when it failed. GAITWAY_FAILED: the port is none to write, or this is not
   * a step. */
  gaitway_status (*publish)(void* context, gaitway_port* port, const void* value);
  /* [any] Puts a line into the host's list of events; cut off after 160 bytes. What comes faster than the
   * ticks take it up is counted, and the count becomes an event. */
  void (*report)(void* context, gaitway_severity severity, const char* text);
  /* [any] What the host offers under that name, such as GAITWAY_NETWORK_EXTENSION; null: it does not. Belongs
   * to the host and lives until destroy returns. */
  const void* (*get_extension)(void* context, const char* name);
} gaitway_host;

/* Of the host: what a plug-in needs that works beside the steps, as a client of its own. */
#define GAITWAY_NETWORK_EXTENSION "gaitway.network/1"
typedef struct gaitway_network {
  /* [any] Path of the socket at which the memory block's server takes clients; empty: there is none. Belongs
   * to the host and lives until destroy returns. `context`: gaitway_host's. */
  const char* (*memory_socket)(void* context);
  /* [any] Always empty: no plug-in is bound to a folder. Lives as long. */
  const char* (*write_folder)(void* context);
} gaitway_network;

/* What create fills in. All but destroy and get_extension answer a status and, when they fail, an error text.
 * The first five are there in every instance; the others may be null. */
typedef struct gaitway_instance {
  void* context;
  gaitway_status (*activate)(void* context, const gaitway_text* error);                       /* [set-up] */
  gaitway_status (*step)(void* context, const gaitway_tick* tick, const gaitway_text* error); /* [tick] */
  gaitway_status (*deactivate)(void* context, const gaitway_text* error);                     /* [set-up] */
  void (*destroy)(void* context);                                                             /* [set-up] */
  /* [tick] Between two steps: a live parameter has this value from now on. */
  gaitway_status (*set_parameter)(void* context, const char* name, const gaitway_value* value,
                                  const gaitway_text* error);
  /* [any] What the plug-in offers under that name, such as GAITWAY_STATE_EXTENSION; null: it does not. Lives
   * until destroy returns. */
  const void* (*get_extension)(void* context, const char* name);
} gaitway_instance;

/* What one version of a plug-in hands on to the next. Its meaning is the plug-in's own. */
typedef struct gaitway_state {
  void* data;
  uint32_t capacity; /* bytes at `data` */
  uint32_t size;     /* bytes in use */
  uint32_t version;  /* grows whenever the meaning of the bytes changes; 0: nothing is handed on */
  uint32_t reserved;
} gaitway_state;

/* Of the plug-in: it hands its state on to the version that takes its place. */
#define GAITWAY_STATE_EXTENSION "gaitway.state/1"
typedef struct gaitway_state_functions {
  /* [tick] Between two steps: fills in data, size and version, at most `capacity` bytes. `context`:
   * gaitway_instance's. */
  gaitway_status (*save_state)(void* context, gaitway_state* state, const gaitway_text* error);
  /* [tick] Before the first step, of a new version that takes over from another: fails for another version
   * or size. */
  gaitway_status (*restore_state)(void* context, const gaitway_state* state, const gaitway_text* error);
} gaitway_state_functions;

/* The one exported symbol. Its first three numbers keep their places in every future version; the sizes
 * are compared only when these fit. */
typedef struct gaitway_plugin {
  uint32_t magic;     /* GAITWAY_PLUGIN_MAGIC */
  uint32_t abi;       /* GAITWAY_PLUGIN_ABI */
  uint32_t abi_minor; /* GAITWAY_PLUGIN_ABI_MINOR */
  uint32_t plugin_size, host_size, instance_size, tick_size, topic_size, float_field_size, sample_size,
      parameter_size, value_size; /* sizeof each */
  const char* name;
  const char* version;
  const char* description;
  /* [set-up] Makes an instance. On failure it has freed everything and writes the error text. */
  gaitway_status (*create)(const gaitway_host* host, gaitway_instance* instance, const gaitway_text* error);
} gaitway_plugin;

/* The head of gaitway_plugin, for its initialiser. */
#define GAITWAY_PLUGIN_HEAD                                                                               \
  GAITWAY_PLUGIN_MAGIC, GAITWAY_PLUGIN_ABI, GAITWAY_PLUGIN_ABI_MINOR, (uint32_t)sizeof(gaitway_plugin),   \
      (uint32_t)sizeof(gaitway_host), (uint32_t)sizeof(gaitway_instance), (uint32_t)sizeof(gaitway_tick), \
      (uint32_t)sizeof(gaitway_topic), (uint32_t)sizeof(gaitway_float_field),                             \
      (uint32_t)sizeof(gaitway_sample), (uint32_t)sizeof(gaitway_parameter), (uint32_t)sizeof(gaitway_value)

extern __attribute__((visibility("default"))) const gaitway_plugin gaitway_plugin_entry;

#ifdef __cplusplus
}
#endif

#endif
