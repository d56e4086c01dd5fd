#include "core/files/common/raise_tags.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/files/common/names.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <vector>

namespace forefront {

namespace {

using TagNameMap = std::map<std::int32_t, std::string>;

/// The tags of one kind of part, boundary or region, in the order of the file.
class LowTags {
  public:
    LowTags(TagNameMap &names, std::string (*defaultName)(const TagNameMap &, std::int32_t))
        : names_(names), defaultName_(defaultName) {}

    void see(std::int32_t tag) {
        if (tag >= 1) {
            greatest_ = std::max(greatest_, tag);
            anyUsual_ = true;
            if (tag != last_) {
                used_.insert(last_ = tag);
            }
        } else if (raised_.emplace(tag, 1).second) {
            order_.push_back(tag);
        }
    }

    /// Chooses the new tags once all are seen; describes them in `list`.
    void choose(std::vector<std::string> &list) {
        const TagNameMap given(names_.begin(), names_.lower_bound(1));
        names_.erase(names_.begin(), names_.lower_bound(1));
        const bool none =
            !anyUsual_ && order_.size() == 1 && order_[0] == 0 && given.count(0) == 0 && names_.count(1) == 0;
        if (order_.empty() || none) {
            return;
        }
        UniqueNames unique;
        for (const auto &[tag, name] : names_) {
            greatest_ = std::max(greatest_, tag);
            unique.claim(name);
        }
        const auto room = static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max() - greatest_);
        std::int32_t next = order_.size() <= room ? greatest_ + 1 : 1;
        for (const std::int32_t tag : order_) {
            while (used_.count(next) > 0 || names_.count(next) > 0) {
                ++next;
            }
            const auto known = given.find(tag);
            const std::string name = unique.claim(known != given.end() ? known->second : defaultName_({}, tag), 200);
            names_.emplace(next, name);
            list.push_back(name + " is " + std::to_string(next));
            raised_[tag] = next;
            used_.insert(next);
        }
    }

    bool any() const { return !order_.empty(); }
    std::int32_t of(std::int32_t tag) const { return tag >= 1 ? tag : raised_.at(tag); }

  private:
    TagNameMap &names_;
    std::string (*defaultName_)(const TagNameMap &, std::int32_t);
    std::map<std::int32_t, std::int32_t> raised_; ///< new tag by tag of the file
    std::vector<std::int32_t> order_;             ///< tags below 1 in the order of the file
    std::set<std::int32_t> used_;
    std::int32_t greatest_ = 0, last_ = 0;
    bool anyUsual_ = false;
};

/// Raises the tags that `forEach` visits.
template <class ForEach>
void raiseKind(LowTags low, ForEach forEach, std::vector<std::string> &list) {
    forEach([&](std::int32_t &tag) { low.see(tag); });
    low.choose(list); // also drops names of tags below 1 that no part has
    if (low.any()) {
        forEach([&](std::int32_t &tag) { tag = low.of(tag); });
    }
}

void noteRaised(const std::vector<std::string> &list, const SourceText &source) {
    constexpr std::size_t kListed = 8;
    if (list.empty()) {
        return;
    }
    std::string text;
    for (std::size_t k = 0; k < std::min(list.size(), kListed); ++k) {
        text += (k > 0 ? ", " : "") + list[k];
    }
    text += list.size() > kListed ? " and " + std::to_string(list.size() - kListed) + " more" : "";
    source.note("raised-tags", "tags must be whole numbers from 1 on; other ones are renumbered: " + text, 0);
}

} // namespace

void raiseTags(Mesh &mesh, const SourceText &source) {
    std::vector<std::string> list;
    raiseKind(
        LowTags(mesh.boundaryNames, boundaryName),
        [&](auto visit) {
            for (TaggedEdge &edge : mesh.edges) {
                visit(edge.tag);
            }
            for (TaggedNode &point : mesh.points) {
                visit(point.tag);
            }
        },
        list);
    raiseKind(
        LowTags(mesh.regionNames, regionName),
        [&](auto visit) {
            for (CellBlock &block : mesh.blocks) {
                std::for_each(block.regions.begin(), block.regions.end(), visit);
            }
        },
        list);
    noteRaised(list, source);
}

void raiseTags(Domain &domain, const SourceText &source) {
    std::vector<std::string> list;
    raiseKind(
        LowTags(domain.boundaryNames, boundaryName),
        [&](auto visit) {
            for (DomainSegment &segment : domain.segments) {
                visit(segment.tag);
            }
            for (ConstraintPoint &point : domain.points) {
                visit(point.tag);
            }
        },
        list);
    raiseKind(
        LowTags(domain.regionNames, regionName),
        [&](auto visit) {
            for (RegionMarker &marker : domain.regionMarkers) {
                visit(marker.tag);
            }
        },
        list);
    noteRaised(list, source);
}

std::int32_t AttributeTags::of(double attribute) {
    if (attribute >= 0.0 && attribute <= std::numeric_limits<std::int32_t>::max() &&
        attribute == std::floor(attribute)) {
        return static_cast<std::int32_t>(attribute);
    }
    const auto [entry, added] = others_.emplace(attribute, -static_cast<std::int32_t>(others_.size()) - 1);
    if (added) {
        names_.emplace(entry->second, (kind_ == TagKind::Region ? "region_" : "boundary_") + exactText(attribute));
    }
    return entry->second;
}

} // namespace forefront
