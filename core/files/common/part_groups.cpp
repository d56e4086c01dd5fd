#include "core/files/common/part_groups.hpp"

#include "core/files/common/names.hpp"

#include <array>
#include <charconv>
#include <limits>
#include <set>

namespace forefront {

namespace {

constexpr std::array<std::string_view, 3> kGroupWords = {"point", "boundary", "region"};

/// Hands out numbers from 1 to a limit, each once.
class GroupNumbers {
  public:
    explicit GroupNumbers(std::int32_t maximum) : maximum_(maximum) {}

    std::int32_t claim(std::int32_t tag, std::int32_t step) {
        for (const std::int64_t number : {std::int64_t{tag}, std::int64_t{tag} + step}) {
            if (number >= 1 && number <= maximum_ && taken_.insert(static_cast<std::int32_t>(number)).second) {
                return static_cast<std::int32_t>(number);
            }
        }
        while (!taken_.insert(lowest_).second) {
            ++lowest_;
        }
        return lowest_;
    }

  private:
    std::int32_t maximum_;
    std::int32_t lowest_ = 1;
    std::set<std::int32_t> taken_;
};

/// Reads a positive integer at the start of a text and removes it with the blank after it; 0 if there is none.
std::int32_t takeNumber(std::string_view &text) {
    std::int32_t number = 0;
    const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
    const auto length = static_cast<std::size_t>(end - text.data());
    if (problem != std::errc{} || number < 1 || length >= text.size() || text[length] != ' ') {
        return 0;
    }
    text.remove_prefix(length + 1);
    return number;
}

} // namespace

PartGroups::PartGroups(const TagList &tags, const GroupLimits &limits) {
    GroupNumbers numbers(limits.number);
    UniqueNames unique;
    const auto add = [&](int dimension, const std::map<std::int32_t, std::string> &names, std::int32_t step,
                         const std::string &ending) {
        for (const auto &[tag, name] : names) {
            std::string label;
            if (limits.labelOf != nullptr) {
                label = limits.labelOf(name, limits.label);
                if (unique.taken(label) && !ending.empty()) {
                    label = limits.labelOf(name, limits.label - ending.size()) + ending;
                }
                label = unique.claim(label, limits.label);
            }
            places_[dimension].emplace(tag, groups_.size());
            groups_.push_back({dimension, tag, numbers.claim(tag, step), name, label});
        }
    };
    add(1, tags.edges, 0, "");
    add(2, tags.regions, 1000, "_region");
    add(0, tags.points, 2000, "_point");
}

void PartGroups::writeOrigins(std::string_view prefix, TextWriter &out) const {
    for (const PartGroup &group : groups_) {
        if (group.dimension == 0 || group.number != group.tag || group.label != group.name) {
            out << prefix << " group " << group.number << ' ' << kGroupWords[group.dimension] << ' ' << group.tag
                << " \"" << percentEncoded(validUtf8(group.name), " ") << "\"\n";
        }
    }
}

Diagnostics PartGroups::noteChanges() const {
    TagList tags;
    FileNames labels;
    for (const PartGroup &group : groups_) {
        auto &from = group.dimension == 0 ? tags.points : group.dimension == 1 ? tags.edges : tags.regions;
        auto &to = group.dimension == 0 ? labels.points : group.dimension == 1 ? labels.edges : labels.regions;
        from.emplace(group.tag, group.name);
        to.emplace(group.tag, group.label);
    }
    return noteChangedNames(tags, labels);
}

std::map<std::int32_t, PartGroup> readGroupOrigins(std::string_view text, std::string_view prefix) {
    std::map<std::int32_t, PartGroup> groups;
    const std::string start = std::string(prefix) + " group ";
    for (std::size_t at = text.find(start); at != std::string_view::npos; at = text.find(start, at + 1)) {
        if (at > 0 && text[at - 1] != '\n') {
            continue;
        }
        std::string_view line = text.substr(at + start.size());
        line = line.substr(0, line.find('\n'));
        PartGroup group;
        group.number = takeNumber(line);
        for (int dimension = 0; dimension < 3 && group.number > 0; ++dimension) {
            if (line.starts_with(kGroupWords[dimension]) &&
                line.substr(kGroupWords[dimension].size()).starts_with(' ')) {
                line.remove_prefix(kGroupWords[dimension].size() + 1);
                group.dimension = dimension;
                group.tag = takeNumber(line);
                const std::size_t close = line.rfind('"');
                if (group.tag > 0 && line.starts_with('"') && close > 0) {
                    group.name = percentDecoded(line.substr(1, close - 1));
                    groups.emplace(group.number, group);
                }
                break;
            }
        }
    }
    return groups;
}

} // namespace forefront
