#include "core/mesher/region_results.hpp"

#include <algorithm>

namespace forefront {

RegionResults::RegionResults(FrontState &whole, std::size_t regions)
    : whole_(whole), first_{whole.nodes.size(), whole.elements.size()}, counts_(regions), finished_(regions),
      copied_(regions, 0), nodes_(whole.nodes.size()), elements_(whole.elements.size()) {}

void RegionResults::finished(std::size_t k, FrontState &state) {
    counts_[k] = {state.nodes.size(), state.elements.size()};
    finished_[k].store(&state, std::memory_order_release);
}

/// Those before it must have finished.
RegionResults::Count RegionResults::offsetOf(std::size_t k) const {
    Count offset = first_;
    for (std::size_t i = 0; i < k; ++i) {
        offset.nodes += counts_[i].nodes;
        offset.elements += counts_[i].elements;
    }
    return offset;
}

void RegionResults::early(std::size_t task) {
    if (task < 2) {
        growEarly(task == 0);
    } else {
        copyEarly(task - 2);
    }
}

/// To what the regions that have finished lead to expect, a little less rather than more.
void RegionResults::growEarly(bool nodes) {
    constexpr double kPart = 0.96;
    if (begun_.load(std::memory_order_acquire) < finished_.size()) {
        return; // one may still be reading the whole
    }
    if (nodes ? whole_.nodes.size() > first_.nodes : whole_.elements.size() > first_.elements) {
        return; // done
    }
    Count sum;
    std::size_t count = 0;
    for (std::size_t k = 0; k < finished_.size(); ++k) {
        if (finished_[k].load(std::memory_order_acquire) != nullptr) {
            sum.nodes += counts_[k].nodes;
            sum.elements += counts_[k].elements;
            ++count;
        }
    }
    const double more = count == 0 ? 0.0 : kPart * static_cast<double>(finished_.size()) / static_cast<double>(count);
    const auto expected = [more](std::size_t first, std::size_t added, std::size_t room) {
        const std::size_t wanted = first + static_cast<std::size_t>(more * static_cast<double>(added));
        return wanted <= room ? wanted : first; // never moves the array
    };
    grow({expected(first_.nodes, sum.nodes, whole_.nodes.capacity()),
          expected(first_.elements, sum.elements, whole_.elements.capacity())},
         nodes);
}

void RegionResults::grow(const Count &to, bool nodes) {
    if (nodes) {
        whole_.nodes.resize(to.nodes);
        nodes_.store(to.nodes, std::memory_order_release);
    } else {
        whole_.elements.resize(to.elements);
        whole_.elementRegions.resize(whole_.manyRegions ? to.elements : 0);
        elements_.store(to.elements, std::memory_order_release);
    }
}

void RegionResults::copyEarly(std::size_t k) {
    if (copied_[k] != 0) {
        return;
    }
    for (std::size_t i = 0; i <= k; ++i) {
        if (finished_[i].load(std::memory_order_acquire) == nullptr) {
            return;
        }
    }
    const Count end = offsetOf(k + 1);
    if (end.nodes <= nodes_.load(std::memory_order_acquire) &&
        end.elements <= elements_.load(std::memory_order_acquire)) {
        copy(k, *finished_[k].load(std::memory_order_relaxed));
    }
}

void RegionResults::copy(std::size_t k, FrontState &from) {
    const Count to = offsetOf(k);
    const std::uint32_t added = shift(k);
    std::copy(from.nodes.begin(), from.nodes.end(), whole_.nodes.begin() + static_cast<std::ptrdiff_t>(to.nodes));
    std::copy(from.elementRegions.begin(), from.elementRegions.end(),
              whole_.elementRegions.begin() + (whole_.manyRegions ? static_cast<std::ptrdiff_t>(to.elements) : 0));
    Element *place = whole_.elements.data() + to.elements;
    for (const Element &e : from.elements) {
        const auto shifted = [&](NodeId n) {
            return index(n) < first_.nodes ? n : NodeId{static_cast<std::uint32_t>(index(n)) + added};
        };
        *place++ = {shifted(e[0]), shifted(e[1]), shifted(e[2])};
    }
    from.nodes = {};
    from.elements = {};
    from.elementRegions = {};
    copied_[k] = 1;
}

void RegionResults::gather(ThreadPool &pool) {
    const Count end = offsetOf(finished_.size());
    pool.run(2, [&](std::size_t array, unsigned) { grow(end, array == 1); });
    pool.run(finished_.size(), [this](std::size_t k, unsigned) {
        if (copied_[k] == 0) {
            copy(k, *finished_[k].load(std::memory_order_relaxed));
        }
    });
}

} // namespace forefront
