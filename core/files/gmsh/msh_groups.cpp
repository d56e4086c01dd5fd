#include "core/files/gmsh/msh_groups.hpp"

#include "core/files/common/names.hpp"
#include "core/files/gmsh/gmsh.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <map>
#include <set>

namespace forefront {

namespace {

constexpr std::int32_t kGreatest = std::numeric_limits<std::int32_t>::max();
constexpr std::size_t kMaximumNameBytes = 127; // of the MSH format
constexpr std::string_view kOrigin = "group ";

using Names = std::map<std::int32_t, std::string>;

bool meet(const Names &a, const Names &b) {
    return std::any_of(a.begin(), a.end(), [&](const auto &entry) { return b.contains(entry.first); });
}

/// Returns the smallest of 1000, 10000, ... above all tags.
std::int64_t baseAbove(const TagList &tags) {
    std::int64_t base = 1000;
    for (const Names *names : {&tags.points, &tags.edges, &tags.regions}) {
        while (!names->empty() && names->rbegin()->first >= base) {
            base *= 10;
        }
    }
    return base;
}

/// Returns the group numbers for the tags of a dimension: the tags, the tags plus an offset, or the first unused
/// numbers.
std::vector<std::int32_t> numbersOf(const Names &names, std::int64_t raise, const std::set<std::int32_t> &used) {
    std::vector<std::int32_t> numbers;
    std::int32_t next = 1;
    for (const auto &[tag, name] : names) {
        if (names.rbegin()->first + raise <= kGreatest) {
            numbers.push_back(static_cast<std::int32_t>(tag + raise));
            continue;
        }
        while (used.contains(next)) {
            ++next;
        }
        numbers.push_back(next++);
    }
    return numbers;
}

/// Returns the name unchanged if no group has it yet, else with a suffix.
std::string labelOf(const std::string &name, std::string_view ending, std::set<std::string> &taken) {
    std::string label = asQuotable(name, kMaximumNameBytes);
    if (taken.contains(label)) {
        label = asQuotable(name, kMaximumNameBytes - ending.size()) + std::string(ending);
    }
    for (int number = 2; !taken.insert(label).second; ++number) {
        const std::string longer = std::string(ending) + '_' + std::to_string(number);
        label = asQuotable(name, kMaximumNameBytes - longer.size()) + longer;
    }
    return label;
}

} // namespace

MshGroups::MshGroups(const MeshView &mesh, bool keepsTags) {
    const TagList tags = tagsOf(mesh);
    const std::int64_t base = keepsTags ? 0 : baseAbove(tags);
    const std::int64_t raiseRegions = meet(tags.regions, tags.edges) || meet(tags.regions, tags.points) ? base : 0;
    const std::int64_t raisePoints = meet(tags.points, tags.edges) ? 2 * base : 0;
    std::set<std::int32_t> used;
    for (const Names *names : {&tags.points, &tags.edges, &tags.regions}) {
        for (const auto &[tag, name] : *names) {
            used.insert(tag);
        }
    }
    std::set<std::string> taken;
    struct Part {
        int dimension;
        const Names &names;
        std::int64_t raise;
        std::string_view ending;
    };
    // Numbers and names are given to edges first, since boundary conditions refer to them.
    for (const Part &part : {Part{1, tags.edges, 0, ""}, Part{2, tags.regions, raiseRegions, "_region"},
                             Part{0, tags.points, raisePoints, "_point"}}) {
        const std::vector<std::int32_t> numbers = numbersOf(part.names, part.raise, used);
        std::size_t k = 0;
        for (const auto &[tag, name] : part.names) {
            groups_.push_back({part.dimension, tag, numbers[k], name,
                               keepsTags ? asQuotable(name, kMaximumNameBytes) : labelOf(name, part.ending, taken)});
            used.insert(numbers[k++]);
        }
    }
    std::stable_sort(groups_.begin(), groups_.end(),
                     [](const MshGroup &a, const MshGroup &b) { return a.dimension < b.dimension; });
}

std::int32_t MshGroups::number(int dimension, std::int32_t tag) const {
    const auto found = std::lower_bound(groups_.begin(), groups_.end(), std::pair(dimension, tag),
                                        [](const MshGroup &group, const std::pair<int, std::int32_t> &key) {
                                            return std::pair(group.dimension, group.tag) < key;
                                        });
    return found->number;
}

std::int32_t MshGroups::unusedNumbers(std::size_t count) const {
    std::int32_t maximum = 0;
    for (const MshGroup &group : groups_) {
        maximum = std::max(maximum, group.number);
    }
    return count < static_cast<std::size_t>(kGreatest - maximum) ? maximum + 1 : 1;
}

void MshGroups::writeNames(TextWriter &out) const {
    out << "$PhysicalNames\n" << groups_.size() << '\n';
    for (const MshGroup &group : groups_) {
        out << group.dimension << ' ' << group.number << " \"" << group.label << "\"\n";
    }
    out << "$EndPhysicalNames\n";
}

void MshGroups::writeOrigins(TextWriter &out, LengthUnit unit) const {
    std::string lines;
    for (const MshGroup &group : groups_) {
        if (group.number != group.tag || group.label != group.name) {
            lines += lines.empty() ? "Tags and names of the mesh: group DIMENSION NUMBER tag TAG \"NAME\"\n" : "";
            lines += std::string(kOrigin) + std::to_string(group.dimension) + ' ' + std::to_string(group.number) +
                     " tag " + std::to_string(group.tag) + " \"" + percentEncoded(validUtf8(group.name)) + "\"\n";
        }
    }
    writeMshComments(lines, unit, out);
}

void writeMshComments(std::string_view lines, LengthUnit unit, TextWriter &out) {
    if (lines.empty() && unit == LengthUnit::None) {
        return;
    }
    out << "$Comments\n" << lines;
    if (unit != LengthUnit::None) {
        out << "Unit of the coordinates: " << wordOf(unit) << '\n';
    }
    out << "$EndComments\n";
}

Diagnostics noteMshChanges(const MeshView &mesh, bool keepsTags) {
    const MshGroups groups(mesh, keepsTags);
    FileNames labels;
    for (const MshGroup &group : groups.groups()) {
        (group.dimension == 0   ? labels.points
         : group.dimension == 1 ? labels.edges
                                : labels.regions)
            .emplace(group.tag, group.label);
    }
    return noteChangedNames(tagsOf(mesh), labels);
}

std::vector<MshGroup> readMshOrigins(std::string_view comments) {
    std::vector<MshGroup> origins;
    while (!comments.empty()) {
        const std::string_view line = comments.substr(0, comments.find('\n'));
        comments.remove_prefix(std::min(line.size() + 1, comments.size()));
        const std::size_t open = line.find('"');
        const std::size_t close = line.rfind('"');
        if (!line.starts_with(kOrigin) || open == close) {
            continue;
        }
        const char *at = line.data() + kOrigin.size();
        const char *const end = line.data() + open;
        bool good = true;
        const auto number = [&](auto &value, std::string_view before) {
            good = good && std::string_view(at, static_cast<std::size_t>(end - at)).starts_with(before);
            if (good) {
                const auto result = std::from_chars(at + before.size(), end, value);
                good = result.ec == std::errc();
                at = result.ptr;
            }
        };
        MshGroup group;
        number(group.dimension, "");
        number(group.number, " ");
        number(group.tag, " tag ");
        group.name = percentDecoded(line.substr(open + 1, close - open - 1));
        if (good && group.dimension >= 0 && group.dimension <= 2 && group.number >= 1 && group.tag >= 1) {
            origins.push_back(std::move(group));
        }
    }
    return origins;
}

void restoreTags(const std::vector<MshGroup> &origins, Mesh &mesh) {
    std::array<std::map<std::int32_t, std::int32_t>, 3> tags;
    for (const MshGroup &group : origins) {
        tags[static_cast<std::size_t>(group.dimension)].emplace(group.number, group.tag);
        (group.dimension == 2 ? mesh.regionNames : mesh.boundaryNames).erase(group.number);
    }
    for (const MshGroup &group : origins) {
        addName(group.dimension == 2 ? mesh.regionNames : mesh.boundaryNames, group.tag, group.name,
                group.dimension == 2);
    }
    const auto restore = [&](std::size_t dimension, std::int32_t &tag) {
        const auto found = tags[dimension].find(tag);
        tag = found != tags[dimension].end() ? found->second : tag;
    };
    for (TaggedNode &point : mesh.points) {
        restore(0, point.tag);
    }
    for (TaggedEdge &edge : mesh.edges) {
        restore(1, edge.tag);
    }
    if (!tags[2].empty()) {
        for (CellBlock &block : mesh.blocks) {
            for (std::int32_t &region : block.regions) {
                restore(2, region);
            }
        }
    }
}

void writeMshElevations(const MeshView &mesh, TextWriter &out) {
    if (mesh.elevations.empty()) {
        return;
    }
    out << "$NodeData\n1\n\"elevation\"\n1\n0\n3\n0\n1\n" << mesh.nodes.size() << '\n';
    for (std::size_t n = 0; n < mesh.nodes.size() && out.ok(); ++n) {
        out << n + 1 << ' ' << mesh.elevations[n] << '\n';
    }
    out << "$EndNodeData\n";
}

} // namespace forefront
