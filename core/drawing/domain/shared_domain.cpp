#include "core/drawing/domain/shared_domain.hpp"

#include "core/drawing/domain/document_domain.hpp"

namespace forefront {

std::shared_ptr<const MeshingJob> SharedDomain::job() {
    const std::lock_guard lock(mutex_);
    if (!job_) {
        job_ = std::make_shared<const MeshingJob>(jobOf(*document_));
    }
    return job_;
}

std::shared_ptr<const Domain> SharedDomain::get() {
    std::shared_ptr<const MeshingJob> made = job();
    return {made, &made->domain};
}

} // namespace forefront
