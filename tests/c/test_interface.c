/* Tests of the C interface, in C99. Usage: forefront_c_test FOLDER */
#include "forefront.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures = 0;

#define CHECK(condition)                                                                                              \
    do {                                                                                                               \
        if (!(condition)) {                                                                                            \
            fprintf(stderr, "%s:%d: failed: %s\n", __FILE__, __LINE__, #condition);                                    \
            ++failures;                                                                                                \
        }                                                                                                              \
    } while (0)

static const double kRectangle[] = {0, 0, 4, 0, 4, 2, 0, 2};

static int finer_on_the_left(size_t count, const double *places, double *sizes, void *user) {
    ++*(int *)user;
    for (size_t k = 0; k < count; ++k) {
        sizes[k] = 0.05 + 0.1 * places[2 * k];
    }
    return 0;
}

static int refuse_to_size(size_t count, const double *places, double *sizes, void *user) {
    (void)count, (void)places, (void)sizes, (void)user;
    return 1;
}

static int count_stages(const char *stage, double fraction, void *user) {
    *(int *)user += strlen(stage) > 0 && fraction >= 0.0 && fraction <= 1.0 ? 1 : 1000000;
    return 0;
}

static int stop_at_once(const char *stage, double fraction, void *user) {
    (void)stage, (void)fraction, (void)user;
    return 1;
}

static forefront_job *rectangle(forefront_context *context) {
    forefront_job *job = forefront_job_new(context);
    CHECK(job != NULL);
    CHECK(forefront_add_loop(context, job, kRectangle, 4, 1) == FOREFRONT_OK);
    return job;
}

static double area_of(const forefront_mesh *mesh) {
    const double *nodes = forefront_nodes(mesh);
    const uint32_t *elements = forefront_block_elements(mesh, 0);
    double area = 0.0;
    for (size_t e = 0; e < forefront_block_size(mesh, 0); ++e) {
        const double *a = nodes + 2 * elements[3 * e], *b = nodes + 2 * elements[3 * e + 1],
                     *c = nodes + 2 * elements[3 * e + 2];
        area += 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
    }
    return area;
}

static void test_mesh_and_file(forefront_context *context, const char *folder) {
    const double hole[] = {1, 0.5, 2, 0.5, 2, 1.5, 1, 1.5};
    const double wall[] = {2.5, 1, 3.5, 1};
    char path[1000];
    forefront_mesh *mesh = NULL, *again = NULL;
    forefront_job *job = rectangle(context);
    CHECK(forefront_add_loop(context, job, hole, 4, 2) == FOREFRONT_OK);
    CHECK(forefront_add_line(context, job, wall, 2, 3) == FOREFRONT_OK);
    CHECK(forefront_add_point(context, job, 0.5, 0.7, 4) == FOREFRONT_OK);
    CHECK(forefront_add_region(context, job, 0.1, 0.1, 9, 0.0, 0.02) == FOREFRONT_OK);
    CHECK(forefront_name_boundary(context, job, 2, "hole") == FOREFRONT_OK);
    CHECK(forefront_name_region(context, job, 9, "steel") == FOREFRONT_OK);
    CHECK(forefront_set_part_size(context, job, 2, 0.05, 0.2) == FOREFRONT_OK);
    CHECK(forefront_set_option(context, job, "improve", "best") == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_OK);
    CHECK(fabs(area_of(mesh) - 7.0) < 1e-12);
    CHECK(forefront_block_count(mesh) == 1 && forefront_block_nodes(mesh, 0) == 3);
    CHECK(forefront_element_count(mesh) == forefront_block_size(mesh, 0));
    CHECK(forefront_block_regions(mesh, 0)[0] == 9);
    CHECK(forefront_check_mesh(context, mesh, job) == FOREFRONT_OK);
    CHECK(forefront_check_mesh(context, mesh, NULL) == FOREFRONT_OK);

    int tags[5] = {0};
    for (size_t k = 0; k < forefront_edge_count(mesh); ++k) {
        uint32_t a = 0, b = 0;
        int32_t tag = 0;
        CHECK(forefront_edge(mesh, k, &a, &b, &tag) == FOREFRONT_OK);
        CHECK(a != b && a < forefront_node_count(mesh) && b < forefront_node_count(mesh) && tag >= 1 && tag <= 3);
        ++tags[tag];
    }
    CHECK(tags[1] > 10 && tags[2] > 60 && tags[3] > 2);

    size_t count = 0;
    CHECK(forefront_measure(context, mesh, "area", NULL, 0, &count) == FOREFRONT_OK);
    CHECK(count == forefront_element_count(mesh));
    double *areas = malloc(count * sizeof *areas), sum = 0.0, largest = 0.0;
    CHECK(forefront_measure(context, mesh, "area", areas, count, &count) == FOREFRONT_OK);
    for (size_t e = 0; e < count; ++e) {
        sum += areas[e];
        largest = areas[e] > largest ? areas[e] : largest;
    }
    CHECK(fabs(sum - 7.0) < 1e-12 && largest <= 0.02 * 1.125);
    free(areas);

    snprintf(path, sizeof path, "%s/c_interface.msh", folder);
    CHECK(forefront_write_mesh(context, mesh, path, NULL) == FOREFRONT_OK);
    CHECK(forefront_read_mesh(context, path, NULL, &again) == FOREFRONT_OK);
    CHECK(forefront_hash(again) == forefront_hash(mesh) && forefront_hash(mesh) != 0);
    forefront_job_free(job); /* the mesh does not need it */
    CHECK(fabs(area_of(mesh) - 7.0) < 1e-12);

    job = forefront_job_new(context);
    CHECK(forefront_read_domain(context, job, path, NULL) == FOREFRONT_OK);
    forefront_mesh_free(again);
    again = NULL;
    CHECK(forefront_mesh_domain(context, job, &again) == FOREFRONT_OK && fabs(area_of(again) - 7.0) < 1e-12);
    remove(path);
    forefront_mesh_free(again);
    forefront_mesh_free(mesh);
    forefront_job_free(job);
}

static void test_faults(forefront_context *context) {
    const double bow_tie[] = {0, 0, 1, 1, 1, 0, 0, 1};
    forefront_mesh *mesh = NULL;
    forefront_job *job = forefront_job_new(context);
    CHECK(forefront_add_loop(context, job, bow_tie, 4, 1) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_REFUSED && mesh == NULL);
    CHECK(strstr(forefront_message(context), "cross at (0.5, 0.5)") != NULL);
    CHECK(strstr(forefront_faults(context), "\"crossing-segments\"") != NULL);
    CHECK(strstr(forefront_faults(context), "0.5") != NULL && strstr(forefront_faults(context), "\"at\"") != NULL);

    CHECK(forefront_add_loop(context, NULL, bow_tie, 4, 1) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_add_loop(context, job, NULL, 4, 1) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_add_loop(NULL, job, bow_tie, 4, 1) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_add_line(context, job, bow_tie, 1, 1) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_set_option(context, job, "method", "slow") == FOREFRONT_BAD_ARGUMENT);
    CHECK(strstr(forefront_message(context), "expected fast or classic, got 'slow'") != NULL);
    CHECK(forefront_set_option(context, job, "threads", "0") == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_set_option(context, job, "threads", "2x") == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_set_option(context, job, "keep-boundary", "maybe") == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_set_option(context, job, "colour", "red") == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_mesh_domain(context, job, NULL) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_read_mesh(context, "/does/not/exist.msh", NULL, &mesh) == FOREFRONT_REFUSED && mesh == NULL);
    CHECK(strstr(forefront_message(context), "exist.msh") != NULL);
    CHECK(forefront_edge(NULL, 0, NULL, NULL, NULL) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_node_count(NULL) == 0 && forefront_nodes(NULL) == NULL && forefront_block_size(NULL, 0) == 0);
    CHECK(forefront_set_option(context, job, "threads", "2") == FOREFRONT_OK);
    CHECK(strcmp(forefront_message(context), "") == 0 && strcmp(forefront_faults(context), "[]") == 0);
    forefront_mesh_free(NULL);
    forefront_job_free(job);
}

static void test_functions(forefront_context *context) {
    int calls = 0, stages = 0;
    forefront_mesh *mesh = NULL, *same = NULL;
    forefront_job *job = rectangle(context);
    CHECK(forefront_set_size_function(context, job, finer_on_the_left, &calls) == FOREFRONT_OK);
    CHECK(forefront_set_progress(context, job, count_stages, &stages) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_OK);
    CHECK(calls > 0 && stages > 2 && stages < 1000000 && forefront_element_count(mesh) > 100);

    forefront_mesh *cancelled = NULL;
    CHECK(forefront_set_progress(context, job, stop_at_once, NULL) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &cancelled) == FOREFRONT_CANCELLED && cancelled == NULL);
    CHECK(forefront_set_progress(context, job, NULL, NULL) == FOREFRONT_OK);
    CHECK(forefront_set_size_function(context, job, refuse_to_size, NULL) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &cancelled) == FOREFRONT_CANCELLED && cancelled == NULL);
    CHECK(forefront_set_size_function(context, job, finer_on_the_left, &calls) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &same) == FOREFRONT_OK);
    CHECK(forefront_hash(same) == forefront_hash(mesh));
    forefront_mesh_free(same);
    forefront_mesh_free(mesh);
    forefront_job_free(job);
}

static void test_quadrilaterals_and_expressions(forefront_context *context) {
    forefront_mesh *mesh = NULL;
    forefront_job *job = rectangle(context);
    CHECK(forefront_set_expression(context, job, "0.1+0.05*x") == FOREFRONT_OK);
    CHECK(forefront_set_option(context, job, "elements", "quads") == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_OK);
    CHECK(forefront_block_count(mesh) == 1 && forefront_block_nodes(mesh, 0) == 4);
    forefront_mesh *second = NULL;
    CHECK(forefront_set_option(context, job, "order", "2") == FOREFRONT_OK);
    CHECK(forefront_set_option(context, job, "quad-nodes", "9") == FOREFRONT_OK);
    CHECK(forefront_set_option(context, job, "order", "3") == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_mesh_domain(context, job, &second) == FOREFRONT_OK);
    CHECK(forefront_block_size(second, 0) == forefront_block_size(mesh, 0) && forefront_block_nodes(second, 0) == 9);
    forefront_mesh_free(second);
    CHECK(forefront_set_expression(context, job, "0.1+") == FOREFRONT_OK);
    forefront_mesh *none = NULL;
    CHECK(forefront_mesh_domain(context, job, &none) == FOREFRONT_REFUSED && none == NULL);
    CHECK(strstr(forefront_faults(context), "expression-syntax") != NULL);
    forefront_mesh_free(mesh);
    forefront_job_free(job);
}

static void test_lines_and_regions(forefront_context *context) {
    const double wall[] = {1, 1, 3, 1};
    forefront_mesh *mesh = NULL, *none = NULL;
    forefront_job *job = rectangle(context);
    size_t block, strip = 0;
    CHECK(forefront_set_size(context, job, 0.25) == FOREFRONT_OK);
    CHECK(forefront_add_line(context, job, wall, 2, 3) == FOREFRONT_OK);
    CHECK(forefront_add_strip(context, job, 3, 0.2, 2, NULL, 5) == FOREFRONT_OK);
    CHECK(forefront_add_strip(context, job, 3, 0.2, 2, "hexes", 0) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_OK);
    for (block = 0; block < forefront_block_count(mesh); ++block) {
        size_t k;
        for (k = 0; k < forefront_block_size(mesh, block); ++k) {
            if (forefront_block_regions(mesh, block)[k] == 5) {
                CHECK(forefront_block_nodes(mesh, block) == 4);
                ++strip;
            }
        }
    }
    CHECK(strip >= 16 && strip % 2 == 0);
    CHECK(forefront_check_mesh(context, mesh, job) == FOREFRONT_OK);
    forefront_mesh_free(mesh);
    CHECK(forefront_add_crack(context, job, 3) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &none) == FOREFRONT_REFUSED && none == NULL);
    CHECK(strstr(forefront_faults(context), "strip-line") != NULL);
    forefront_job_free(job);

    job = rectangle(context);
    CHECK(forefront_add_mapped(context, job, 1, NULL, 0) == FOREFRONT_OK);
    CHECK(forefront_add_mapped(context, job, 1, NULL, 4) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_set_region_elements(context, job, 1, "quads") == FOREFRONT_OK);
    CHECK(forefront_set_region_elements(context, job, 1, NULL) == FOREFRONT_BAD_ARGUMENT);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_OK);
    CHECK(forefront_block_count(mesh) == 1 && forefront_block_nodes(mesh, 0) == 4);
    forefront_mesh_free(mesh);
    CHECK(forefront_add_periodic(context, job, 1, 9) == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &none) == FOREFRONT_REFUSED);
    forefront_job_free(job);

    job = rectangle(context);
    CHECK(forefront_add_layers(context, job, 1, 0.01, 1.2, 4, 0.0, "triangles") == FOREFRONT_OK);
    CHECK(forefront_mesh_domain(context, job, &mesh) == FOREFRONT_OK);
    CHECK(forefront_block_count(mesh) == 1);
    forefront_mesh_free(mesh);
    forefront_job_free(job);
}

int main(int argc, char **argv) {
    if (argc != 2) {
        fprintf(stderr, "usage: %s FOLDER\n", argv[0]);
        return 2;
    }
    forefront_context *context = forefront_context_new();
    CHECK(context != NULL && strlen(forefront_version()) > 0);
    test_mesh_and_file(context, argv[1]);
    test_faults(context);
    test_functions(context);
    test_quadrilaterals_and_expressions(context);
    test_lines_and_regions(context);
    forefront_context_free(context);
    printf("%d checks failed\n", failures);
    return failures == 0 ? 0 : 1;
}
