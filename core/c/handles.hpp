#pragma once

#include "core/c/forefront.h"
#include "core/engine/base/result.hpp"
#include "core/engine/mesher/options.hpp"
#include "core/engine/pipeline/pipeline.hpp"

#include <memory>
#include <new>
#include <string>

/// The faults of the last call, and the texts made of them.
struct forefront_context {
    forefront::Diagnostics faults;
    std::string message;
    std::string json;
};

/// A job, and the functions of the caller.
struct forefront_job {
    forefront::MeshingJob job;
    forefront_progress_function progress = nullptr;
    void *user = nullptr;                                  ///< of `progress`
    std::vector<forefront::PeriodicSpec> periodicOfMesh{}; ///< those of the job that a mesh file shows
};

/// A mesh, each of whose elements has a region, with the spacing that it was made for.
struct forefront_mesh {
    forefront::Mesh mesh;
    std::shared_ptr<const forefront::SpacingField> spacing; ///< null: unknown
};

namespace forefront::c {

/// Thrown by a size function of the caller that returned nonzero.
struct Cancelled {};

/// Keeps faults in a context and returns the status for them.
forefront_status report(forefront_context &context, Diagnostics faults);

/// Reports an argument that is null, out of range or no known word.
forefront_status badArgument(forefront_context &context, const std::string &message);

/// Runs a function that returns a status. No exception leaves it.
template <class Function>
forefront_status guarded(forefront_context *context, const Function &function) noexcept {
    if (context == nullptr) {
        return FOREFRONT_BAD_ARGUMENT;
    }
    try {
        report(*context, {});
        return function();
    } catch (const Cancelled &) {
        return FOREFRONT_CANCELLED;
    } catch (const std::bad_alloc &) {
        return FOREFRONT_OUT_OF_MEMORY;
    }
}

} // namespace forefront::c
