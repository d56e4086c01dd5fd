/**
 * @file
 * The C interface of Forefront: domains in, meshes out, for programs in C and for languages that call C.
 *
 * A forefront_context holds the faults of the last call that took it; use each from one thread at a time. Nothing else
 * is shared: different contexts, jobs and meshes may be used by different threads. Functions of a
 * status return FOREFRONT_OK or what went wrong, and then leave their results alone. Strings are UTF-8; indices count
 * from 0; lengths are in the units of the domain. Functions are added, but neither changed nor removed, within a minor version.
 *
 * @code{.c}
 * forefront_context *context = forefront_context_new();
 * forefront_job *job = forefront_job_new(context);
 * const double corners[] = {0, 0, 4, 0, 4, 3, 0, 3};
 * forefront_mesh *mesh = NULL;
 * forefront_add_loop(context, job, corners, 4, 1);
 * forefront_set_size(context, job, 0.25);
 * if (forefront_mesh_domain(context, job, &mesh) != FOREFRONT_OK ||
 *     forefront_write_mesh(context, mesh, "rectangle.msh", NULL) != FOREFRONT_OK) {
 *     fprintf(stderr, "%s\n", forefront_message(context));
 * }
 * forefront_mesh_free(mesh);
 * forefront_job_free(job);
 * forefront_context_free(context);
 * @endcode
 */
#ifndef FOREFRONT_H
#define FOREFRONT_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define FOREFRONT_C_API __attribute__((visibility("default")))
#else
#define FOREFRONT_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/** The result of a call. */
typedef enum forefront_status {
    FOREFRONT_OK = 0,
    FOREFRONT_REFUSED = 1,      /**< the domain, a size or a file is invalid; see forefront_faults() */
    FOREFRONT_BAD_ARGUMENT = 2, /**< an argument is null, out of range, or no known word */
    FOREFRONT_CANCELLED = 3,    /**< by the progress function */
    FOREFRONT_OUT_OF_MEMORY = 4
} forefront_status;

/** The faults of the last call. */
typedef struct forefront_context forefront_context;
/** A domain with its element sizes and the options of the mesher. */
typedef struct forefront_job forefront_job;
/** A mesh; it does not change. */
typedef struct forefront_mesh forefront_mesh;

/** Fills in the sizes at `count` places, x and y of each in turn; > 0. Returns nonzero to cancel. */
typedef int (*forefront_size_function)(size_t count, const double *places, double *sizes, void *user);
/** Is told the stage and the fraction of it that is done, in [0, 1]. Returns nonzero to cancel. */
typedef int (*forefront_progress_function)(const char *stage, double fraction, void *user);

/** Returns the version of the library, "MAJOR.MINOR.PATCH". */
FOREFRONT_C_API const char *forefront_version(void);

/** Returns a new context; null if memory runs out. */
FOREFRONT_C_API forefront_context *forefront_context_new(void);
FOREFRONT_C_API void forefront_context_free(forefront_context *context);
/** Returns the faults of the last call as text, one a line; empty if there are none. Valid until the next call. */
FOREFRONT_C_API const char *forefront_message(const forefront_context *context);
/**
 * Returns the faults, warnings and notes of the last call as a JSON array of objects with the members severity, code, message, advice, at
 * ([x, y] or null), file and line. Valid until the next call.
 */
FOREFRONT_C_API const char *forefront_faults(const forefront_context *context);

/** Returns a job with an empty domain and automatic sizes; null if memory runs out. */
FOREFRONT_C_API forefront_job *forefront_job_new(forefront_context *context);
FOREFRONT_C_API void forefront_job_free(forefront_job *job);
/** Replaces the domain and the sizes by those of a file: .poly, or the outline of a mesh. `format`: id; null: by content. */
FOREFRONT_C_API forefront_status forefront_read_domain(forefront_context *context, forefront_job *job, const char *path,
                                                       const char *format);
/** Adds a closed polygon of `count` corners, x and y of each in turn. A loop inside another loop is a hole. */
FOREFRONT_C_API forefront_status forefront_add_loop(forefront_context *context, forefront_job *job,
                                                    const double *corners, size_t count, int32_t tag);
/** Adds a polyline inside the domain, which becomes edges of the mesh. */
FOREFRONT_C_API forefront_status forefront_add_line(forefront_context *context, forefront_job *job,
                                                    const double *places, size_t count, int32_t tag);
/** Adds a point that becomes a node. */
FOREFRONT_C_API forefront_status forefront_add_point(forefront_context *context, forefront_job *job, double x, double y,
                                                     int32_t tag);
/** Gives the face around a place a tag, and limits of its elements: a size and a maximum area, 0 for none. */
FOREFRONT_C_API forefront_status forefront_add_region(forefront_context *context, forefront_job *job, double x,
                                                      double y, int32_t tag, double size, double max_area);
/** Makes the face around a place a hole. Faces without such a place are then inside the domain. */
FOREFRONT_C_API forefront_status forefront_add_hole(forefront_context *context, forefront_job *job, double x, double y);
/** Names a boundary part, or a region. */
FOREFRONT_C_API forefront_status forefront_name_boundary(forefront_context *context, forefront_job *job, int32_t tag,
                                                         const char *name);
FOREFRONT_C_API forefront_status forefront_name_region(forefront_context *context, forefront_job *job, int32_t tag,
                                                       const char *name);

/**
 * Adds boundary layers on a part: the height of the first one, the growth (1.2 is usual), and their number or their
 * height altogether, 0 for none of both. `elements`: "quads" or "triangles"; null: quads.
 */
FOREFRONT_C_API forefront_status forefront_add_layers(forefront_context *context, forefront_job *job, int32_t tag,
                                                      double first, double growth, uint32_t count, double thickness,
                                                      const char *elements);
/** Makes a crack of an inner line: the elements on its two sides get nodes of their own. */
FOREFRONT_C_API forefront_status forefront_add_crack(forefront_context *context, forefront_job *job, int32_t tag);
/** Divides two boundary parts alike, the second of which is the first one moved or turned. */
FOREFRONT_C_API forefront_status forefront_add_periodic(forefront_context *context, forefront_job *job, int32_t from,
                                                        int32_t to_tag);
/**
 * Fills the faces of a region by rows of elements. `corners`: x and y of 3 or 4 nodes of each face in turn; null: the
 * sharpest ones.
 */
FOREFRONT_C_API forefront_status forefront_add_mapped(forefront_context *context, forefront_job *job, int32_t region,
                                                      const double *corners, size_t count);
/**
 * Gives an inner line a width, and fills the strip along it by rows of elements. `elements`: "quads" or "triangles";
 * null: quads. `region`: tag of the strip; 0: a tag of its own.
 */
FOREFRONT_C_API forefront_status forefront_add_strip(forefront_context *context, forefront_job *job, int32_t tag,
                                                     double width, uint32_t rows, const char *elements,
                                                     int32_t region);
/** Sets the shapes of the elements of one region: "triangles", "quads" or "mixed". */
FOREFRONT_C_API forefront_status forefront_set_region_elements(forefront_context *context, forefront_job *job,
                                                               int32_t region, const char *elements);

/** Sets the size everywhere. */
FOREFRONT_C_API forefront_status forefront_set_size(forefront_context *context, forefront_job *job, double size);
/** Sets the size by an expression in x and y. */
FOREFRONT_C_API forefront_status forefront_set_expression(forefront_context *context, forefront_job *job,
                                                          const char *expression);
/** Sets the size by a function, which the thread that meshes calls. The same place must give the same size. */
FOREFRONT_C_API forefront_status forefront_set_size_function(forefront_context *context, forefront_job *job,
                                                             forefront_size_function function, void *user);
/** Sets the size on a boundary part, which grows by `growth` per unit of distance from it. */
FOREFRONT_C_API forefront_status forefront_set_part_size(forefront_context *context, forefront_job *job, int32_t tag,
                                                         double size, double growth);
/**
 * Sets an option by the name and the value that it has on the command line: elements, order, quad-nodes, method, grid,
 * improve, threads, keep-boundary (true or false), min-angle, max-elements, gradation, elements-across,
 * segments-per-turn.
 */
FOREFRONT_C_API forefront_status forefront_set_option(forefront_context *context, forefront_job *job, const char *name,
                                                      const char *value);
/** Sets the function that is told the progress; null: none. */
FOREFRONT_C_API forefront_status forefront_set_progress(forefront_context *context, forefront_job *job,
                                                        forefront_progress_function function, void *user);

/** Meshes the domain of a job. The caller frees the mesh. */
FOREFRONT_C_API forefront_status forefront_mesh_domain(forefront_context *context, const forefront_job *job,
                                                       forefront_mesh **mesh);
/** Reads a mesh. `format`: id, such as "msh2"; null: by content, then by extension. The caller frees it. */
FOREFRONT_C_API forefront_status forefront_read_mesh(forefront_context *context, const char *path, const char *format,
                                                     forefront_mesh **mesh);
/** Writes a mesh. `format`: id; null: by extension. A file is replaced as a whole or not at all. */
FOREFRONT_C_API forefront_status forefront_write_mesh(forefront_context *context, const forefront_mesh *mesh,
                                                      const char *path, const char *format);
/** Checks a mesh, against the domain of a job unless it is null. FOREFRONT_REFUSED: it has faults. */
FOREFRONT_C_API forefront_status forefront_check_mesh(forefront_context *context, const forefront_mesh *mesh,
                                                      const forefront_job *job);
/**
 * Writes the values of a measure, such as "alpha" or "min-angle", for at most `capacity` parts, and their number to `count`,
 * which may be larger. `values` may be null if `capacity` is 0.
 */
FOREFRONT_C_API forefront_status forefront_measure(forefront_context *context, const forefront_mesh *mesh,
                                                   const char *measure, double *values, size_t capacity,
                                                   size_t *count);

FOREFRONT_C_API void forefront_mesh_free(forefront_mesh *mesh);
FOREFRONT_C_API size_t forefront_node_count(const forefront_mesh *mesh);
/** Returns x and y of each node in turn. Valid as long as the mesh. */
FOREFRONT_C_API const double *forefront_nodes(const forefront_mesh *mesh);
FOREFRONT_C_API size_t forefront_element_count(const forefront_mesh *mesh);
/** Returns the number of blocks: one for each kind of elements. */
FOREFRONT_C_API size_t forefront_block_count(const forefront_mesh *mesh);
/** Returns the number of elements of a block, and of nodes of each. 0 for a block that does not exist. */
FOREFRONT_C_API size_t forefront_block_size(const forefront_mesh *mesh, size_t block);
FOREFRONT_C_API size_t forefront_block_nodes(const forefront_mesh *mesh, size_t block);
/** Returns the nodes of each element of a block in turn, counter-clockwise. Valid as long as the mesh. */
FOREFRONT_C_API const uint32_t *forefront_block_elements(const forefront_mesh *mesh, size_t block);
/** Returns the region tag of each element of a block. Valid as long as the mesh. */
FOREFRONT_C_API const int32_t *forefront_block_regions(const forefront_mesh *mesh, size_t block);
/** Returns the number of tagged edges: the boundary and the lines. */
FOREFRONT_C_API size_t forefront_edge_count(const forefront_mesh *mesh);
/** Returns a tagged edge: its nodes and its tag. BAD_ARGUMENT if it does not exist. */
FOREFRONT_C_API forefront_status forefront_edge(const forefront_mesh *mesh, size_t edge, uint32_t *a, uint32_t *b,
                                                int32_t *tag);
/** Returns the hash of the mesh, which `forefront check` prints. */
FOREFRONT_C_API uint64_t forefront_hash(const forefront_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
