#include "core/mesher/region_results.hpp"

namespace forefront {

RegionResults::RegionResults(FrontState &whole, std::size_t regions)
    : whole_(whole), firstNew_(static_cast<std::uint32_t>(whole.nodes.size())), shifts_(regions), finished_(regions) {}

void RegionResults::finished(std::size_t k, FrontState &state) {
    std::unique_lock lock(mutex_);
    finished_[k] = &state;
    if (taking_) {
        return; // that thread will see it
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

void RegionResults::take(std::size_t k, FrontState &from) {
    const std::uint32_t first = firstNew_, shift = static_cast<std::uint32_t>(whole_.nodes.size()) - first;
    shifts_[k] = shift;
    for (Element &element : from.elements) {
        for (NodeId &n : element) {
            n = NodeId{static_cast<std::uint32_t>(index(n)) + (index(n) < first ? 0U : shift)};
        }
    }
    const auto append = []<class T>(std::vector<T> &to, std::vector<T> &added) {
        to.insert(to.end(), added.begin(), added.end());
        added = std::vector<T>(); // gives its memory back, other than = {}
    };
    append(whole_.nodes, from.nodes);
    append(whole_.elements, from.elements);
    append(whole_.elementRegions, from.elementRegions);
}

} // namespace forefront
