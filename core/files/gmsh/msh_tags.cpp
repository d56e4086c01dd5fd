#include "core/engine/domain/domain.hpp"
#include "core/engine/domain/unused_tag.hpp"
#include "core/files/common/names.hpp"
#include "core/files/gmsh/msh_file.hpp"

#include <algorithm>
#include <limits>
#include <set>

namespace forefront {

/// The tags of one kind of part: those in use, and new ones for parts without a tag.
class MshTags {
  public:
    MshTags(std::map<std::int32_t, std::string> &names, TagKind kind) : names_(names), kind_(kind) {
        for (const auto &[tag, name] : names) {
            taken_.insert(tag);
        }
    }

    void take(std::int32_t tag) { taken_.insert(tag); }
    bool taken(std::int32_t tag) const { return taken_.count(tag) > 0; }
    /// Returns the tag of an entity without a group: its own number if that is free, otherwise an unused one.
    std::int32_t ofEntity(std::int32_t mark) {
        const auto known = entities_.find(mark);
        if (known != entities_.end()) {
            return known->second;
        }
        const std::int32_t number = mark == std::numeric_limits<std::int32_t>::min() ? 0 : -mark;
        const std::int32_t tag = number > 0 && taken_.count(number) == 0 ? number : unusedTag(taken_, names_, kind_);
        take(tag);
        entities_.emplace(mark, tag);
        return tag;
    }
    std::int32_t unused() {
        const std::int32_t tag = unusedTag(taken_, names_, kind_);
        take(tag);
        return tag;
    }

  private:
    std::map<std::int32_t, std::string> &names_;
    TagKind kind_;
    std::set<std::int32_t> taken_;
    std::map<std::int32_t, std::int32_t> entities_; ///< by mark
};

namespace {

/// Returns the number, at least 1, of the entity that a mark stands for; see ungrouped().
std::int32_t entityOf(std::int32_t mark) {
    return mark == std::numeric_limits<std::int32_t>::min() ? 1 : -mark;
}

} // namespace

std::int32_t ungrouped(std::int64_t entity) {
    constexpr std::int64_t kMax = std::numeric_limits<std::int32_t>::max();
    return entity < 1 ? std::numeric_limits<std::int32_t>::min()
                      : static_cast<std::int32_t>(-std::min<std::int64_t>(entity, kMax));
}

void MshFile::resolveTags() {
    spreadBareNames();
    dropConstructionPoints();
    resolveEdgesAndPoints();
    resolveRegions();
    builder_.mesh.regionNames = names_[2];
}

/// Gives each name without a dimension to the groups with its number.
void MshFile::spreadBareNames() {
    if (bareNames_.empty()) {
        return;
    }
    const auto give = [&](std::int32_t tag, std::size_t dimension) {
        const auto found = bareNames_.find(tag);
        if (found != bareNames_.end()) {
            addName(names_[dimension], tag, found->second, dimension == 2);
        }
    };
    for (const TaggedNode &point : builder_.mesh.points) {
        give(point.tag, 0);
    }
    for (const TaggedEdge &edge : builder_.mesh.edges) {
        give(edge.tag, 1);
    }
    for (const std::int32_t region : builder_.elements.regions) {
        give(region, 2);
    }
}

void MshFile::resolveRegions() {
    std::vector<std::int32_t> &regions = builder_.elements.regions;
    MshTags tags(names_[2], TagKind::Region);
    for (const std::int32_t region : regions) {
        if (region > 0) {
            tags.take(region);
        }
    }
    std::size_t count = 0;
    for (std::int32_t &region : regions) {
        if (region < 1) {
            region = tags.ofEntity(region);
            ++count;
        }
    }
    if (count > 0 && count < regions.size()) {
        scanner_.source().note("no-group", "elements outside every physical group are put in a separate region",
                               elementsOffset_, count);
    }
}

/// Edges and points share one table of names, but their groups are numbered apart in MSH.
void MshFile::resolveEdgesAndPoints() {
    Mesh &mesh = builder_.mesh;
    mesh.boundaryNames = names_[1];
    MshTags tags(mesh.boundaryNames, TagKind::Boundary);
    std::size_t grouped = 0;
    for (const TaggedEdge &edge : mesh.edges) {
        if (edge.tag > 0) {
            tags.take(edge.tag);
            ++grouped;
        }
    }
    for (TaggedEdge &edge : mesh.edges) {
        edge.tag = edge.tag > 0 ? edge.tag : tags.ofEntity(edge.tag);
    }
    if (grouped > 0 && grouped < mesh.edges.size()) {
        scanner_.source().note("no-group", "lines outside every physical group are given a separate tag",
                               elementsOffset_, mesh.edges.size() - grouped);
    }
    placePoints(tags, grouped > 0);
}

/// Leaves out points without a group that no element uses, such as the centres of arcs that Gmsh saves, too.
void MshFile::dropConstructionPoints() {
    Mesh &mesh = builder_.mesh;
    const ElementList &elements = builder_.elements;
    if (elements.empty() || mesh.points.empty()) {
        return;
    }
    std::vector<std::uint8_t> used(mesh.nodes.size(), 0);
    for (std::size_t e = 0; e < elements.size(); ++e) {
        for (const NodeId node : elements.nodesOf(e)) {
            used[index(node)] = 1;
        }
    }
    for (const TaggedEdge &edge : mesh.edges) {
        used[index(edge.a)] = used[index(edge.b)] = 1;
    }
    const std::size_t dropped = std::erase_if(
        mesh.points, [&](const TaggedNode &point) { return point.tag < 1 && used[index(point.node)] == 0; });
    if (dropped > 0) {
        scanner_.source().note("lone-point", "points outside every physical group and element are left out",
                               elementsOffset_, dropped);
    }
}

void MshFile::placePoints(MshTags &tags, bool groupedEdges) {
    Mesh &mesh = builder_.mesh;
    std::map<std::int32_t, std::int32_t> moved; ///< new tag by group number; 0: points without a group
    for (TaggedNode &point : mesh.points) {
        const std::int32_t group = std::max(point.tag, 0);
        if (group == 0 && !groupedEdges) {
            point.tag = entityOf(point.tag);
            continue;
        }
        const auto own = names_[0].find(group);
        const bool named = own != names_[0].end();
        if (group > 0 && (!tags.taken(group) || boundaryName(names_[0], group) == boundaryName(names_[1], group))) {
            if (named) {
                mesh.boundaryNames.insert(*own);
            }
            continue;
        }
        const auto [entry, added] = moved.emplace(group, 0);
        if (added) {
            entry->second = tags.unused();
            if (named) {
                mesh.boundaryNames.emplace(entry->second, own->second);
            }
        }
        point.tag = entry->second;
    }
}

} // namespace forefront
