#include "core/drawing/domain/shared_domain.hpp"

#include "core/drawing/domain/document_domain.hpp"

namespace forefront {

std::shared_ptr<const Domain> SharedDomain::get() {
    const std::lock_guard lock(mutex_);
    if (!domain_) {
        domain_ = std::make_shared<const Domain>(toDomain(*document_));
    }
    return domain_;
}

} // namespace forefront
