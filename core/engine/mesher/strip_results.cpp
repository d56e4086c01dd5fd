#include "core/engine/mesher/strip_results.hpp"

namespace forefront {

StripResults::StripResults(FrontState &whole, std::size_t strips)
    : whole_(whole), firstNew_(static_cast<std::uint32_t>(whole.nodes.size())), shifts_(strips), finished_(strips) {}

void StripResults::finished(std::size_t k, FrontState &state) {
    std::unique_lock lock(mutex_);
    finished_[k] = &state;
    if (taking_) {
        return; // that thread merges this strip, too
    }
    taking_ = true;
    for (; next_ < finished_.size() && finished_[next_] != nullptr; ++next_) {
        const std::size_t present = next_;
        FrontState &from = *finished_[present];
        lock.unlock();
        take(present, from);
        lock.lock();
    }
    taking_ = false;
}

void StripResults::take(std::size_t k, FrontState &from) {
    const std::uint32_t first = firstNew_, shift = static_cast<std::uint32_t>(whole_.nodes.size()) - first;
    shifts_[k] = shift;
    for (Element &element : from.elements) {
        for (NodeId &n : element) {
            n = NodeId{static_cast<std::uint32_t>(index(n)) + (index(n) < first ? 0U : shift)};
        }
    }
    const auto append = []<class T>(std::vector<T> &to, std::vector<T> &added) {
        to.insert(to.end(), added.begin(), added.end());
        added = std::vector<T>(); // releases its memory, which = {} does not
    };
    append(whole_.nodes, from.nodes);
    append(whole_.elements, from.elements);
    append(whole_.elementFaces, from.elementFaces);
}

} // namespace forefront
