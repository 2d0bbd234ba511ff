// SPDX-License-Identifier: MIT
/// @file base.h
/// Tier 0. Version, result codes, and the only process-wide state of the library: the hooks for memory, log, assertions
/// and tasks.
///
/// There are three kinds of error, and no call mixes them:
/// - *misuse* (a NULL that must not be NULL, an index out of range) goes to the assert hook;
/// - *creation and I/O* return a ::bolan_result and log one sentence: what was wrong, where, and what was expected;
/// - *per-frame calls* cannot fail.
#ifndef BOLAN_BASE_H
#define BOLAN_BASE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/// Marks the declarations that a shared library exports; everything else of it is hidden.
#if defined(__GNUC__)
#define BOLAN_API __attribute__((visibility("default")))
#else
#define BOLAN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/// Major version: raised when a caller must change its code.
#define BOLAN_VERSION_MAJOR 0
/// Minor version: raised when functions or fields are added.
#define BOLAN_VERSION_MINOR 2
/// Patch version: raised when only defects are corrected.
#define BOLAN_VERSION_PATCH 0
/// Version of the headers; bolan_version() returns the version of the library.
#define BOLAN_VERSION_STRING "0.2.0"

/// Size of a name in a desc [bytes], NUL included.
#define BOLAN_NAME_MAX 64
/// Size of a path in a desc [bytes], NUL included.
#define BOLAN_PATH_MAX 1024

/// Returns the version of the linked library, "major.minor.patch".
/// Static storage. Thread-safe.
BOLAN_API const char *bolan_version(void);

/// What a creation or I/O call returns.
/// Zero is success. Every failure is logged as one sentence before the call returns.
typedef enum bolan_result {
    BOLAN_OK = 0,
    /// A field or argument is outside its documented range, or not finite.
    BOLAN_ERROR_ARGUMENT,
    /// The allocator returned NULL.
    BOLAN_ERROR_MEMORY,
    /// A file could not be opened, read or written.
    BOLAN_ERROR_IO,
    /// The content of a file does not match its format.
    BOLAN_ERROR_FORMAT,
    /// Valid, but not supported by this build or this machine.
    BOLAN_ERROR_UNSUPPORTED,
    /// OpenGL: no context, a shader did not compile, a target is incomplete.
    BOLAN_ERROR_GL,
} bolan_result;

/// Returns a short English name of a result code, such as "format error".
/// Static storage. Thread-safe.
BOLAN_API const char *bolan_result_string(bolan_result result);

// ---- log ------------------------------------------------------------------------------------------------------------

/// Severity of a message.
/// ERROR: the call failed.
/// WARNING: the call went on, with something missing, replaced or lowered.
/// INFO: nothing is wrong.
typedef enum bolan_log_level { BOLAN_LOG_ERROR, BOLAN_LOG_WARNING, BOLAN_LOG_INFO } bolan_log_level;

/// X(id, name) for each message of the library.
/// Ids are stable and never reused, so that a test can assert which check fired.
#define BOLAN_LOG_TABLE(X)          \
    X(100, OUT_OF_MEMORY)           \
    X(101, BAD_ARGUMENT)            \
    X(102, NOT_FINITE)              \
    X(103, OUT_OF_RANGE)            \
    X(104, UNKNOWN_NAME)            \
    X(105, UNSUPPORTED)             \
    X(200, SPECTRUM_EMPTY)          \
    X(201, SPECTRUM_SYNTAX)         \
    X(202, SPECTRUM_TRUNCATED)      \
    X(203, SPECTRUM_NEGATIVE)       \
    X(204, SPECTRUM_NO_ENERGY)      \
    X(205, SPECTRUM_UNKNOWN_FORMAT) \
    X(206, SPECTRUM_TIME_INDEX)     \
    X(207, SPECTRUM_WRONG_TABLE)    \
    X(208, SPECTRUM_NO_DIRECTIONS)  \
    X(209, SPECTRUM_MISSING)        \
    X(210, SPECTRUM_LOCATION)       \
    X(211, SPECTRUM_IMPOSSIBLE)     \
    X(212, SPECTRUM_DATE)           \
    X(213, SPECTRUM_NEAREST_TIME)   \
    X(214, SPECTRUM_UNUSED)         \
    X(215, SPECTRUM_GAP)            \
    X(300, FILE_OPEN)               \
    X(301, FILE_READ)               \
    X(302, FILE_WRITE)              \
    X(303, FILE_TOO_LARGE)          \
    X(304, SCENE_TOO_DEEP)          \
    X(305, FILE_UNPACK)             \
    X(310, SCENE_SYNTAX)            \
    X(311, SCENE_UNKNOWN_KEY)       \
    X(312, SCENE_BAD_VALUE)         \
    X(320, RASTER_OPEN)             \
    X(321, RASTER_EMPTY)            \
    X(322, RASTER_PROJECTION)       \
    X(323, RASTER_CHOICE)           \
    X(324, RASTER_UNIT)             \
    X(325, RASTER_HOLES)            \
    X(326, RASTER_VALUES)           \
    X(327, RASTER_LIBRARY)          \
    X(328, RASTER_CRS)              \
    X(329, RASTER_READ)             \
    X(330, IMAGE_FORMAT)            \
    X(335, MODEL_FORMAT)            \
    X(336, MODEL_EXTENSION)         \
    X(337, MODEL_LIMIT)             \
    X(340, VIDEO_PROGRAM)           \
    X(341, VIDEO_WRITE)             \
    X(345, EXPORT_TOO_LARGE)        \
    X(346, EXPORT_LEFT_OUT)         \
    X(347, EXPORT_PRECISION)        \
    X(400, GL_CONTEXT)              \
    X(401, GL_VERSION)              \
    X(402, GL_SHADER)               \
    X(403, GL_TARGET)               \
    X(404, GL_DEBUG)                \
    X(405, GL_LOADER)               \
    X(502, POINTS_SYNTAX)           \
    X(503, SEA_LIMITED)             \
    X(504, SEA_BLOCKED)             \
    X(505, SEA_BOUND_LIMITED)       \
    X(506, SEA_ORDER)               \
    X(910, LAYER_STEEP)             \
    X(930, WORLD_MODEL)             \
    X(931, WORLD_ASSETS)            \
    X(940, VIEW)                    \
    X(950, BAKE_WANTED)             \
    X(960, GUEST_PROGRAM)           \
    X(961, GUEST_SLOTS)             \
    X(962, GUEST_LIGHT)             \
    X(963, GUEST_FRAME)

/// The ids of ::BOLAN_LOG_TABLE as BOLAN_LOG_&lt;NAME&gt;, their value the id.
typedef enum bolan_log_id {
#define BOLAN_LOG_ENUM(id, name) BOLAN_LOG_##name = id,
    BOLAN_LOG_TABLE(BOLAN_LOG_ENUM)
#undef BOLAN_LOG_ENUM
} bolan_log_id;

// ---- hooks ----------------------------------------------------------------------------------------------------------

/// A slice of a parallel loop: processes the items [begin, end).
/// @p worker is in [0, workers) and unique among the slices that run at the same time, so it can index scratch memory.
typedef void bolan_task_fn(void *context, uint32_t begin, uint32_t end, uint32_t worker);

/// Runs a whole parallel loop of @p count items in slices of at least @p grain, and returns when all are done.
typedef void bolan_parallel_fn(void *user, uint32_t count, uint32_t grain, bolan_task_fn *task, void *context);

/// Process-wide hooks.
/// A NULL member keeps the built-in behaviour.
typedef struct bolan_hooks {
    /// First argument of every hook.
    void *user;
    /// Memory of @p size bytes, aligned to @p align, a power of two of at most 64; NULL on failure.
    void *(*allocate)(void *user, size_t size, size_t align);
    /// Releases memory of allocate().
    /// @p size is the size that allocate() was called with.
    void (*release)(void *user, void *memory, size_t size);
    /// Receives one sentence.
    /// Default: prints one line on stderr.
    void (*log)(void *user, bolan_log_level level, bolan_log_id id, const char *sentence);
    /// Called on misuse.
    /// Default: prints the expression and aborts.
    void (*assert_failed)(void *user, const char *expression, const char *file, int line);
    /// Runs parallel loops on the task system of the caller.
    /// Default: the built-in pool, see bolan_set_threads().
    bolan_parallel_fn *parallel;
    /// Number of workers that @ref parallel can use at once, at least 1.
    /// 0 is misuse and counts as 1.
    uint32_t parallel_workers;
    /// Returns the address of the OpenGL function @p name, such as "glClear"; NULL where there is none.
    /// Called once for each function that bolan_render uses, on the thread of the first call into bolan_render, with a
    /// context current.
    /// Default: libepoxy; a library that was built without it needs the hook.
    void *(*get_proc_address)(void *user, const char *name);
} bolan_hooks;

/// Replaces the hooks; NULL restores the built-in behaviour.
/// Call it before anything is created and while no other thread is in the library, because memory must be released by
/// the hook that allocated it.
/// Not thread-safe.
BOLAN_API void bolan_set_hooks(const bolan_hooks *hooks);
/// Returns the hooks in force; a member is NULL where the built-in behaviour is in force.
/// A plug-in calls it to add its own hooks to the hooks of the host.
/// Thread-safe while no thread calls bolan_set_hooks().
BOLAN_API bolan_hooks bolan_get_hooks(void);

/// Sets the number of threads of the built-in pool, the calling thread included.
/// 1..64; default 1, where the library starts no thread. 0: one for each online processor.
/// The threads sleep between loops; 1 ends them.
/// Results never depend on the number of threads.
/// Not thread-safe.
BOLAN_API void bolan_set_threads(uint32_t threads);

/// Returns the number of workers that a parallel loop may use now, >= 1.
/// Thread-safe.
BOLAN_API uint32_t bolan_threads(void);

/// Runs @p task over [0, count) on the hook or the built-in pool, and waits for its end.
/// Loops do not nest: a loop started inside a task runs on the thread of that task.
/// Thread-safe.
BOLAN_API void bolan_parallel(uint32_t count, uint32_t grain, bolan_task_fn *task, void *context);

/// Called after each step of work that takes a while: @p done of @p total steps.
typedef void bolan_progress(void *user, uint32_t done, uint32_t total);

/// Allocates memory through the hooks: zero-filled, aligned to 64 bytes.
/// Returns NULL for @p size 0 and on failure.
/// Thread-safe if the hook is.
BOLAN_API void *bolan_allocate(size_t size);
/// Moves memory of bolan_allocate() into an allocation of @p larger bytes, whose rest is zero, and releases the old.
/// @p size is the size of the old allocation, @p memory NULL: nothing is moved.
/// Returns NULL on failure, and leaves the old allocation as it is.
/// Thread-safe if the hook is.
BOLAN_API void *bolan_enlarge(void *memory, size_t size, size_t larger);
/// Releases memory of bolan_allocate().
/// @p size is the size that bolan_allocate() was called with.
/// NULL-safe.
BOLAN_API void bolan_release(void *memory, size_t size);
/// Returns the memory that the library holds now [bytes].
/// Thread-safe.
BOLAN_API size_t bolan_memory_in_use(void);

/// Emits one log sentence, printf style, with numbers in the C locale.
/// For the modules of the library and for tools built on it.
/// Control characters and bytes that are not UTF-8 are escaped as by bolan_text_escape(), so that a sentence is one
/// line and no input can steer a terminal. A sentence ends after 2047 bytes. Thread-safe.
#if defined(__GNUC__)
BOLAN_API __attribute__((format(printf, 3, 4)))
#endif
BOLAN_API void BOLAN_API
bolan_log(bolan_log_level level, bolan_log_id id, const char *format, ...);

/// Reports misuse to the assert hook; called by BOLAN_ASSERT().
BOLAN_API void bolan_assert_failed(const char *expression, const char *file, int line);
/// Reports misuse where @p x is false, in every build.
/// Execution goes on if the hook returns.
#define BOLAN_ASSERT(x) ((x) ? (void)0 : bolan_assert_failed(#x, __FILE__, __LINE__))

// ---- numbers and text -----------------------------------------------------------------------------------------------

/// Like snprintf(), with numbers in the C locale whatever locale the program has set: a decimal point, no grouping.
/// For all text that a machine reads.
/// Thread-safe.
#if defined(__GNUC__)
BOLAN_API __attribute__((format(printf, 3, 4)))
#endif
BOLAN_API int BOLAN_API
bolan_format(char *out, size_t capacity, const char *format, ...);
/// Writes @p value as "%.*g" does in the C locale with @p digits 1..12, several times as fast; -0 keeps its sign.
/// @p capacity is 32 at least. Returns the length. Thread-safe.
BOLAN_API int bolan_format_number(char *out, size_t capacity, double value, int digits);
/// Reads a decimal number, [+-]digits[.digits][e[+-]digits], that fills all @p size bytes of @p text.
/// The number is correctly rounded and read in the C locale.
/// Returns false for anything else: blanks, "nan", "inf", hexadecimal, more than 400 bytes, or a number beyond the
/// range of a double. Thread-safe.
BOLAN_API bool bolan_parse_number(const char *text, size_t size, double *value);

/// Returns how many bytes of @p text fit into @p most without a cut inside a UTF-8 character; for "%.*s".
/// Thread-safe.
BOLAN_API size_t bolan_text_fit(const char *text, size_t most);
/// Copies @p text for a terminal.
/// Control characters (C0, DEL, C1, line breaks, changes of direction) and bytes that are not UTF-8 become escapes,
/// such as \\n, \\t, \\x1b or \\u009b. An incomplete character at the end is left out. The copy ends with the last
/// whole character that fits into @p capacity bytes, NUL included. Thread-safe.
BOLAN_API void bolan_text_escape(const char *text, char *out, size_t capacity);

// ---- instruction sets -----------------------------------------------------------------------------------------------

/// Which build of the wide kernels runs.
/// All builds give the same bits.
typedef enum bolan_cpu {
    /// The widest set of this machine.
    BOLAN_CPU_AUTO,
    /// Plain C.
    BOLAN_CPU_SCALAR,
    /// 128-bit vectors that every compiler makes of the one source: SSE2, NEON, WebAssembly SIMD.
    BOLAN_CPU_GENERIC4,
    /// 256-bit vectors of x86-64.
    BOLAN_CPU_AVX2,
    /// 512-bit vectors of x86-64.
    BOLAN_CPU_AVX512,
} bolan_cpu;
/// Number of instruction sets.
#define BOLAN_CPUS 5
/// The names that the command line uses, "auto", "scalar" ...; indexed by bolan_cpu, NULL at the end.
BOLAN_API extern const char *const bolan_cpu_names[BOLAN_CPUS + 1];

/// Returns the widest instruction set of this machine.
/// Thread-safe.
BOLAN_API bolan_cpu bolan_cpu_best(void);
/// Returns "auto", "scalar", "generic4", "avx2" or "avx512".
/// Static storage. Thread-safe.
BOLAN_API const char *bolan_cpu_name(bolan_cpu cpu);

#ifdef __cplusplus
}
#endif
#endif
