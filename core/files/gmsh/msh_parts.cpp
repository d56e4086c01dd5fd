#include "core/files/gmsh/msh_parts.hpp"

#include "core/engine/base/vec2.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace forefront {

namespace {

class GroupScanner {
  public:
    explicit GroupScanner(std::string_view text) : text_(text) {}

    std::optional<std::map<std::int32_t, MshCurveGroup>> run() {
        if (!enter("$MeshFormat")) {
            return std::nullopt;
        }
        const bool version4 = real() >= 4.0;
        if (integer() != 0) {
            return std::nullopt; // binary
        }
        if (enter("$PhysicalNames")) {
            names();
        }
        if (version4 && enter("$Entities")) {
            entities();
        }
        if (version4 && enter("$PartitionedEntities")) {
            pieces();
        }
        if (enter("$Nodes")) {
            version4 ? nodes4() : nodes2(false);
        } else if (enter("$ParametricNodes")) {
            nodes2(true);
        } else {
            return std::nullopt;
        }
        if (enter("$Elements")) {
            version4 ? elements4() : elements2();
        }
        return sound_ ? std::optional(std::move(groups_)) : std::nullopt;
    }

  private:
    bool enter(std::string_view section) {
        for (std::size_t at = text_.find(section); at != std::string_view::npos; at = text_.find(section, at + 1)) {
            if (at == 0 || text_[at - 1] == '\n') {
                at_ = at + section.size();
                return true;
            }
        }
        return false;
    }
    void skipBlanks() {
        while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') {
            ++at_;
        }
    }
    template <class Number>
    Number number() {
        skipBlanks();
        Number value{};
        const char *const begin = text_.data() + at_;
        const auto [end, problem] = std::from_chars(begin, text_.data() + text_.size(), value);
        sound_ = sound_ && problem == std::errc{};
        at_ = sound_ ? at_ + static_cast<std::size_t>(end - begin) : text_.size();
        return value;
    }
    std::int64_t integer() { return number<std::int64_t>(); }
    double real() { return number<double>(); }
    void skipReals(std::int64_t count) {
        for (; count > 0 && sound_; --count) {
            real();
        }
    }

    void names() {
        for (std::int64_t left = integer(); left > 0 && sound_; --left) {
            const std::int64_t dimension = integer();
            const auto tag = static_cast<std::int32_t>(integer());
            const std::size_t open = text_.find('"', at_);
            const std::size_t close = text_.find('"', std::min(open, text_.size() - 1) + 1);
            if (open == std::string_view::npos || close == std::string_view::npos) {
                sound_ = false;
                return;
            }
            at_ = close + 1;
            if (dimension == 1) {
                names_[tag] = std::string(text_.substr(open + 1, close - open - 1));
            }
        }
    }

    void entities() {
        std::int64_t counts[4] = {integer(), integer(), integer(), integer()};
        for (; counts[0] > 0 && sound_; --counts[0]) {
            integer();
            skipReals(3);
            for (std::int64_t left = integer(); left > 0 && sound_; --left) {
                integer();
            }
        }
        for (; counts[1] > 0 && sound_; --counts[1]) {
            const std::int64_t curve = integer();
            skipReals(6);
            const std::int64_t groups = integer();
            for (std::int64_t k = 0; k < groups && sound_; ++k) {
                const std::int64_t group = integer();
                if (k == 0) {
                    groupOfCurve_[curve] = static_cast<std::int32_t>(group < 0 ? -group : group);
                }
            }
            for (std::int64_t left = integer(); left > 0 && sound_; --left) {
                integer();
            }
        }
    }

    /// Reads the curves of a partitioned mesh, each with its parent, and finds their groups.
    void pieces() {
        integer();
        skipIntegers(2 * integer());
        std::int64_t counts[4] = {integer(), integer(), integer(), integer()};
        for (; counts[0] > 0 && sound_; --counts[0]) {
            skipIntegers(3);
            skipIntegers(integer());
            skipReals(3);
            skipIntegers(integer());
        }
        for (; counts[1] > 0 && sound_; --counts[1]) {
            const std::int64_t curve = integer();
            const bool betweenPartitions = integer() != 1;
            const std::int64_t parent = integer();
            skipIntegers(integer());
            skipReals(6);
            const std::int64_t groups = integer();
            std::int64_t group = groupOfCurve_.count(parent) > 0 ? groupOfCurve_[parent] : 0;
            for (std::int64_t k = 0; k < groups && sound_; ++k) {
                const std::int64_t own = integer();
                group = k == 0 ? own : group;
            }
            pieceGroups_[curve] = betweenPartitions ? 0 : static_cast<std::int32_t>(group < 0 ? -group : group);
            skipIntegers(integer());
        }
        for (const auto &[curve, group] : pieceGroups_) {
            groupOfCurve_[curve] = group;
        }
    }
    void skipIntegers(std::int64_t count) {
        for (; count > 0 && sound_; --count) {
            integer();
        }
    }

    void nodes2(bool parametric) {
        for (std::int64_t left = integer(); left > 0 && sound_; --left) {
            const std::int64_t node = integer();
            const double x = real(), y = real();
            places_[node] = {x, y};
            real();
            at_ = parametric ? std::min(text_.find('\n', at_), text_.size()) : at_;
        }
    }

    void nodes4() {
        std::int64_t blocks = integer();
        skipReals(3);
        for (; blocks > 0 && sound_; --blocks) {
            const std::int64_t dimension = integer();
            integer();
            const bool parametric = integer() != 0;
            const std::int64_t count = integer();
            std::vector<std::int64_t> numbers;
            for (std::int64_t k = 0; k < count && sound_; ++k) {
                numbers.push_back(integer());
            }
            for (const std::int64_t node : numbers) {
                const double x = real(), y = real();
                places_[node] = {x, y};
                skipReals(1 + (parametric ? dimension : 0));
            }
        }
    }

    void elements2() {
        for (std::int64_t left = integer(); left > 0 && sound_; --left) {
            integer();
            const std::int64_t type = integer();
            std::int64_t group = 0;
            const std::int64_t tags = integer();
            for (std::int64_t k = 0; k < tags && sound_; ++k) {
                const std::int64_t tag = integer();
                group = k == 0 ? tag : group;
            }
            connection(type, static_cast<std::int32_t>(group < 0 ? -group : group));
        }
    }

    void elements4() {
        std::int64_t blocks = integer();
        skipReals(3);
        for (; blocks > 0 && sound_; --blocks) {
            integer();
            const std::int64_t entity = integer(), type = integer();
            const auto group = groupOfCurve_.find(entity);
            for (std::int64_t left = integer(); left > 0 && sound_; --left) {
                integer();
                connection(type, group == groupOfCurve_.end() ? 0 : group->second);
            }
        }
    }

    void connection(std::int64_t type, std::int32_t group) {
        // Numbers of nodes by type, of points, lines, triangles and quadrilaterals.
        static const std::map<std::int64_t, std::int64_t> kNodes = {{15, 1}, {1, 2}, {8, 3},  {2, 3},
                                                                    {9, 6},  {3, 4}, {16, 8}, {10, 9}};
        constexpr std::int64_t kLine = 1, kLine3 = 8;
        const auto nodes = kNodes.find(type);
        if (nodes == kNodes.end()) {
            sound_ = false;
            return;
        }
        if (type != kLine && type != kLine3) {
            skipIntegers(nodes->second);
            return;
        }
        const std::int64_t a = integer(), b = integer(), middle = type == kLine3 ? integer() : a;
        if (group > 0 && lines_.insert(std::minmax(a, b)).second) {
            MshCurveGroup &entry = groups_[group];
            entry.name = names_[group];
            const Vec2 from = places_[a], to = places_[b], through = places_[middle];
            constexpr double kStraight = 1e-12;
            entry.length += distance(from, to);
            entry.curved = entry.curved ||
                           distance(from, through) + distance(through, to) > (1.0 + kStraight) * distance(from, to);
        }
    }

    std::string_view text_;
    std::size_t at_ = 0;
    bool sound_ = true;
    std::map<std::int32_t, std::string> names_;
    std::map<std::int64_t, std::int32_t> groupOfCurve_, pieceGroups_;
    std::unordered_map<std::int64_t, Vec2> places_;
    std::set<std::pair<std::int64_t, std::int64_t>> lines_;
    std::map<std::int32_t, MshCurveGroup> groups_;
};

} // namespace

std::optional<std::map<std::int32_t, MshCurveGroup>> mshCurveGroups(std::string_view text) {
    return GroupScanner(text).run();
}

} // namespace forefront
