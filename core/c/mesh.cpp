#include "core/c/handles.hpp"
#include "core/engine/mesh/measures.hpp"
#include "core/engine/mesh/mesh_access.hpp"
#include "core/engine/mesh/mesh_view.hpp"
#include "core/engine/mesh/verify.hpp"
#include "core/engine/pipeline/optional_periodic.hpp"
#include "core/files/files.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

using forefront::c::badArgument;
using forefront::c::guarded;
using forefront::c::report;

namespace {

/// Gives the caller a mesh, each of whose elements has a region.
forefront_status handOver(forefront::Mesh mesh, std::shared_ptr<const forefront::SpacingField> spacing,
                          forefront_mesh **to) {
    for (forefront::CellBlock &block : mesh.blocks) {
        if (block.regions.empty()) {
            block.regions.assign(block.size(), 1);
        }
    }
    *to = new forefront_mesh{std::move(mesh), std::move(spacing)};
    return FOREFRONT_OK;
}

/// Returns a progress that asks the function of a job, and throws where it cancels.
forefront::Progress progressFor(const forefront_job &job) {
    forefront::Progress progress;
    if (job.progress != nullptr) {
        progress.report = [&job](std::string_view stage, double fraction) {
            if (job.progress(std::string(stage).c_str(), fraction, job.user) != 0) {
                throw forefront::c::Cancelled{};
            }
        };
    }
    return progress;
}

const forefront::CellBlock *blockOf(const forefront_mesh *mesh, std::size_t block) {
    return mesh != nullptr && block < mesh->mesh.blocks.size() ? &mesh->mesh.blocks[block] : nullptr;
}

} // namespace

forefront_status forefront_mesh_domain(forefront_context *context, const forefront_job *job, forefront_mesh **mesh) {
    return guarded(context, [&] {
        if (job == nullptr || mesh == nullptr) {
            return badArgument(*context, "the job or the place for the mesh is null");
        }
        const forefront::MeshingJob *run = &job->job;
        forefront::MeshingJob changed;
        forefront::Diagnostics notes;
        if (!job->periodicOfMesh.empty()) {
            changed = job->job;
            notes = leaveOutExcludedPeriodic(changed, job->periodicOfMesh);
            run = &changed;
        }
        forefront::Result<forefront::MeshingOutcome> outcome = meshDomain(*run, progressFor(*job));
        if (!outcome) {
            return report(*context, outcome.faults());
        }
        const forefront::Diagnostics ofSpacing = outcome->spacing->notes();
        notes.insert(notes.end(), ofSpacing.begin(), ofSpacing.end());
        report(*context, notes);
        return handOver(std::move(outcome->mesh), std::move(outcome->spacing), mesh);
    });
}

forefront_status forefront_read_mesh(forefront_context *context, const char *path, const char *format,
                                     forefront_mesh **mesh) {
    return guarded(context, [&] {
        if (path == nullptr || mesh == nullptr) {
            return badArgument(*context, "the path or the place for the mesh is null");
        }
        forefront::ImportOptions options;
        options.formatId = format == nullptr ? "" : format;
        forefront::Result<forefront::Mesh> read = forefront::readMesh(std::filesystem::path(path), options);
        return read ? handOver(std::move(*read), nullptr, mesh) : report(*context, read.faults());
    });
}

forefront_status forefront_write_mesh(forefront_context *context, const forefront_mesh *mesh, const char *path,
                                      const char *format) {
    return guarded(context, [&] {
        if (mesh == nullptr || path == nullptr) {
            return badArgument(*context, "the mesh or the path is null");
        }
        return report(*context, forefront::writeMesh(path, mesh->mesh, format == nullptr ? "" : format));
    });
}

forefront_status forefront_check_mesh(forefront_context *context, const forefront_mesh *mesh,
                                      const forefront_job *job) {
    return guarded(context, [&] {
        if (mesh == nullptr) {
            return badArgument(*context, "the mesh is null");
        }
        if (job == nullptr) {
            return report(*context, verify(mesh->mesh));
        }
        const forefront::MeshingJob &given = job->job;
        forefront::Domain domain = given.domain;
        std::vector<std::uint32_t> elements = given.spacing.placed.elements;
        std::vector<forefront::ElementBias> biases = given.spacing.placed.biases;
        if (const auto faults = widenStrips(given.strips, given.cracks, {}, domain, elements, biases);
            !faults.empty()) {
            return report(*context, faults);
        }
        return report(*context, verifyAgainst(mesh->mesh, domain, {elements, biases}, forefront::kMaxListedFaults, {},
                                              true, given.cracks));
    });
}

forefront_status forefront_measure(forefront_context *context, const forefront_mesh *mesh, const char *measure,
                                   double *values, size_t capacity, size_t *count) {
    return guarded(context, [&] {
        if (mesh == nullptr || measure == nullptr || count == nullptr || (values == nullptr && capacity > 0)) {
            return badArgument(*context, "the mesh, the measure or a place for the result is null");
        }
        const auto known = forefront::fromWord<forefront::Measure>(measure);
        if (!known) {
            return badArgument(*context, "measure: expected " + forefront::wordList<forefront::Measure>() + ", got '" +
                                             measure + "'");
        }
        const std::vector<double> found = measureValues(*known, mesh->mesh, edgesOf(mesh->mesh), mesh->spacing.get());
        *count = found.size();
        std::copy_n(found.begin(), std::min(capacity, found.size()), values);
        return FOREFRONT_OK;
    });
}

void forefront_mesh_free(forefront_mesh *mesh) {
    delete mesh;
}

size_t forefront_node_count(const forefront_mesh *mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.nodes.size();
}

const double *forefront_nodes(const forefront_mesh *mesh) {
    return mesh == nullptr ? nullptr : forefront::coordinates(mesh->mesh).data();
}

size_t forefront_element_count(const forefront_mesh *mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.elementCount();
}

size_t forefront_block_count(const forefront_mesh *mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.blocks.size();
}

size_t forefront_block_size(const forefront_mesh *mesh, size_t block) {
    const forefront::CellBlock *const found = blockOf(mesh, block);
    return found == nullptr ? 0 : found->size();
}

size_t forefront_block_nodes(const forefront_mesh *mesh, size_t block) {
    const forefront::CellBlock *const found = blockOf(mesh, block);
    return found == nullptr ? 0 : found->traits().nodes;
}

const uint32_t *forefront_block_elements(const forefront_mesh *mesh, size_t block) {
    const forefront::CellBlock *const found = blockOf(mesh, block);
    return found == nullptr ? nullptr : forefront::connectivity(*found).data();
}

const int32_t *forefront_block_regions(const forefront_mesh *mesh, size_t block) {
    const forefront::CellBlock *const found = blockOf(mesh, block);
    return found == nullptr ? nullptr : found->regions.data();
}

size_t forefront_edge_count(const forefront_mesh *mesh) {
    return mesh == nullptr ? 0 : mesh->mesh.edges.size();
}

forefront_status forefront_edge(const forefront_mesh *mesh, size_t edge, uint32_t *a, uint32_t *b, int32_t *tag) {
    if (mesh == nullptr || edge >= mesh->mesh.edges.size() || a == nullptr || b == nullptr || tag == nullptr) {
        return FOREFRONT_BAD_ARGUMENT;
    }
    const forefront::TaggedEdge &found = mesh->mesh.edges[edge];
    *a = static_cast<uint32_t>(forefront::index(found.a));
    *b = static_cast<uint32_t>(forefront::index(found.b));
    *tag = found.tag;
    return FOREFRONT_OK;
}

uint64_t forefront_hash(const forefront_mesh *mesh) {
    return mesh == nullptr ? 0 : meshHash(mesh->mesh);
}
