#include "core/teaching/trace/trace_read.hpp"

#include "core/files/json/json_check.hpp"

#include <limits>
#include <string>
#include <utility>

namespace forefront {

namespace {

class TraceReader {
  public:
    explicit TraceReader(const SourceText &source) : check_(source) {}

    Result<std::vector<TracedAdvance>> read(const JsonValue &root) {
        const auto list = root.find("advances");
        if (!list || !list->is(JsonKind::Array)) {
            check_.fault(list.value_or(root), "not-a-trace", "not a trace: the list \"advances\" is missing",
                         R"(a trace is {"advances": [{"base": {"a": [x, y], "b": [x, y]}, ...}, ...]})");
            return check_.faults();
        }
        std::vector<TracedAdvance> advances;
        for (const JsonValue item : *list) {
            if (check_.expect(item, JsonKind::Object, "an advance")) {
                advances.push_back(advance(item));
            }
            if (check_.full()) {
                break;
            }
        }
        if (!check_.faults().empty()) {
            return check_.faults();
        }
        return advances;
    }

  private:
    TracedAdvance advance(const JsonValue &item) {
        TracedAdvance advance;
        advance.offset = item.offset();
        if (const auto base = check_.member(item, "base", "the advance");
            base && check_.expect(*base, JsonKind::Object, "\"base\"")) {
            advance.a = end(*base, "a");
            advance.b = end(*base, "b");
        }
        if (const auto rho = item.find("rho")) {
            advance.rho = check_.number(*rho, "\"rho\"");
        }
        if (const auto ideal = item.find("c")) {
            advance.ideal = check_.point(*ideal, "\"c\"");
        }
        if (const auto list = item.find("candidates")) {
            advance.candidates = candidates(*list);
        }
        if (const auto list = item.find("elements")) {
            advance.elements = elements(*list);
        }
        if (const auto front = item.find("front")) {
            advance.front = static_cast<std::uint64_t>(
                check_.integer(*front, 0, std::numeric_limits<std::uint32_t>::max(), "\"front\""));
        }
        return advance;
    }
    Vec2 end(const JsonValue &base, std::string_view name) {
        const auto at = check_.member(base, name, "the base");
        return at ? check_.point(*at, "an end of the base") : Vec2{};
    }
    std::vector<TracedCandidate> candidates(const JsonValue &list) {
        std::vector<TracedCandidate> found;
        if (check_.expect(list, JsonKind::Array, "\"candidates\"")) {
            for (const JsonValue item : list) {
                if (check_.expect(item, JsonKind::Object, "a candidate")) {
                    found.push_back(candidate(item));
                }
            }
        }
        return found;
    }
    TracedCandidate candidate(const JsonValue &item) {
        TracedCandidate candidate;
        if (const auto at = check_.member(item, "at", "the candidate")) {
            candidate.at = check_.point(*at, "the place of a candidate");
        }
        if (const auto score = item.find("score")) {
            candidate.score = check_.number(*score, "\"score\"");
        }
        if (const auto verdict = item.find("verdict")) {
            candidate.verdict = static_cast<Verdict>(check_.choice(*verdict, wordsOf<Verdict>(), "a verdict"));
        }
        return candidate;
    }
    std::vector<std::array<Vec2, 3>> elements(const JsonValue &list) {
        std::vector<std::array<Vec2, 3>> made;
        if (!check_.expect(list, JsonKind::Array, "\"elements\"")) {
            return made;
        }
        for (const JsonValue item : list) {
            const std::vector<Vec2> corners = check_.points(item, "the corners of an element");
            if (corners.size() == 3) {
                made.push_back({corners[0], corners[1], corners[2]});
            } else if (check_.faults().empty()) {
                check_.fault(item, "bad-value", "an element has 3 corners, not " + std::to_string(corners.size()));
            }
        }
        return made;
    }

    JsonCheck check_;
};

} // namespace

Result<std::vector<TracedAdvance>> readTrace(const SourceText &source) {
    const Result<JsonDocument> document = JsonDocument::parse(source);
    if (!document) {
        return document.faults();
    }
    return TraceReader(source).read(document->root());
}

} // namespace forefront
