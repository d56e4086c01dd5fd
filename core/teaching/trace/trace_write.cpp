#include "core/teaching/trace/trace_write.hpp"

#include "core/engine/session/mesh_stepper.hpp"
#include "core/files/json/json_text.hpp"
#include "core/files/rules/rules_json.hpp"

#include <cstdint>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

namespace forefront {

namespace {

const char *squareWord(SquareKind square) {
    switch (square) {
    case SquareKind::Row:
        return "row";
    case SquareKind::Opening:
        return "opening";
    case SquareKind::Closing:
        return "closing";
    case SquareKind::None:
        break;
    }
    return "half";
}

/// Writes the advances of a run, each on a line.
class TraceWriter {
  public:
    TraceWriter(MeshStepper &stepper, TextWriter &out) : stepper_(stepper), out_(out), json_(out) {}

    /// Writes the rules if they differ from their defaults.
    void rules(const FrontRules &rules) {
        if (rules != FrontRules()) {
            out_ << "\"rules\": ";
            writeRules(rules, json_);
            out_ << ",\n";
        }
    }
    /// Writes the divided boundary: the nodes by number, and the segments of Γ before the first advance, oldest first.
    void boundary() {
        out_ << "\"boundary\": {\"nodes\": [";
        json_.list(stepper_.mesh().nodes, ", ", [&](Vec2 node) { json_.point(node); });
        out_ << ']';
        if (const std::vector<std::uint8_t> colours = stepper_.triangles().colours; !colours.empty()) {
            out_ << ",\n  \"colours\": [";
            json_.list(colours, ", ", [&](std::uint8_t colour) { out_ << static_cast<unsigned>(colour); });
            out_ << ']';
        }
        out_ << ",\n  \"segments\": [";
        json_.list(stepper_.front(), ", ", [&](const FrontSegmentView &segment) {
            out_ << '[' << index(segment.nodeA) << ", " << index(segment.nodeB) << ']';
        });
        out_ << "]}";
    }
    /// Writes the last advance.
    void advance() {
        const std::shared_ptr<const AdvanceExplanation> told = stepper_.explanation();
        const AdvanceExplanation &advance = *told;
        out_ << "  {\"advance\": " << advance.advance;
        point(R"(, "base": {"a": )", advance.a);
        point(R"(, "b": )", advance.b);
        out_ << ", \"nodes\": [" << index(advance.nodeA) << ", " << index(advance.nodeB) << ']';
        if (const std::uint32_t equal = equalBases(advance); equal > 0) {
            out_ << ", \"equal\": " << equal;
        }
        out_ << '}';
        if (advance.coloured) {
            square(advance);
        }
        number(", \"field-rho\": ", advance.fieldRho);
        number(", \"rho\": ", advance.rho);
        point(", \"c\": ", advance.ideal);
        number(", \"radius\": ", advance.searchRadius);
        out_ << ",\n   \"candidates\": [";
        json_.list(advance.candidates, ",\n     ", [&](const CandidateTrace &c) { candidate(c); });
        out_ << "],\n   \"delivered\": " << advance.delivered << ", \"cells\": " << advance.cells.size()
             << ", \"tests\": [";
        json_.list(advance.tests, ", ", [&](const TestTrace &tested) { test(tested); });
        out_ << "],\n   \"elements\": [";
        json_.list(advance.made, ", ", [&](const std::array<Vec2, 3> &corners) {
            out_ << '[';
            json_.list(corners, ", ", [&](Vec2 corner) { json_.point(corner); });
            out_ << ']';
        });
        out_ << "], \"front\": " << stepper_.front().size() << '}';
    }

  private:
    static std::uint32_t equalBases(const AdvanceExplanation &advance) {
        return advance.events.empty() || advance.events.front().step != Step::TakeBase ? 0U
                                                                                       : advance.events.front().equal;
    }
    /// Writes what an advance of the two-coloured front has taken and made.
    void square(const AdvanceExplanation &advance) {
        out_ << ", \"diagonal\": " << (advance.diagonal ? "true" : "false") << ", \"row\": " << advance.row
             << ", \"square\": \"" << squareWord(advance.square)
             << "\", \"forced\": " << (advance.forced ? "true" : "false");
    }
    void candidate(const CandidateTrace &candidate) {
        point("{\"at\": ", candidate.position);
        out_ << ", \"node\": ";
        if (candidate.node == kNoNode) {
            out_ << "null";
        } else {
            out_ << index(candidate.node);
        }
        number(", \"alpha\": ", candidate.alpha);
        number(", \"delta-ac\": ", candidate.deltaAC);
        number(", \"delta-cb\": ", candidate.deltaCB);
        number(", \"score\": ", candidate.score);
        out_ << ", \"verdict\": \"" << wordOf(candidate.verdict) << '"';
        if (candidate.square != SquareKind::None) {
            out_ << ", \"square\": \"" << squareWord(candidate.square) << "\", \"over\": [";
            json_.list(candidate.over, ", ", [&](Vec2 place) { json_.point(place); });
            out_ << ']';
        }
        if (candidate.square == SquareKind::Opening || candidate.square == SquareKind::Closing) {
            point(", \"second\": ", candidate.second);
        }
        if (candidate.colour >= 0) {
            out_ << ", \"colour\": " << candidate.colour;
        }
        out_ << '}';
    }
    void test(const TestTrace &test) {
        point("{\"from\": ", test.candidateFrom);
        point(", \"to\": ", test.candidateTo);
        point(", \"segment\": [", test.frontA);
        point(", ", test.frontB);
        out_ << "], \"meets\": " << (test.meets ? "true" : "false") << '}';
    }
    void number(std::string_view name, double value) {
        out_ << name;
        json_.number(value);
    }
    void point(std::string_view name, Vec2 at) {
        out_ << name;
        json_.point(at);
    }

    MeshStepper &stepper_;
    TextWriter &out_;
    JsonText json_;
};

} // namespace

Status writeTrace(MeshingJob job, std::optional<std::uint64_t> steps, TextWriter &out, const Progress &progress) {
    job.options.improve = ImproveLevel::None;
    job.options.order = ElementOrder::First;
    const std::string_view method = wordOf(job.options.method), grid = wordOf(job.options.grid);
    const std::string_view elements = wordOf(job.options.elements);
    const bool classic = job.options.method == Method::Classic && !makesQuads(job.options);
    const FrontRules rules = classic ? job.options.rules : FrontRules();
    Result<MeshStepper> stepper = MeshStepper::create(std::move(job), progress);
    if (!stepper) {
        return stepper.faults();
    }
    const std::uint64_t last = steps.value_or(std::numeric_limits<std::uint64_t>::max());
    TraceWriter trace(*stepper, out);
    out << "{\"format\": \"forefront-trace\", \"version\": 1, \"method\": \"" << method << "\", \"grid\": \"" << grid
        << "\", \"elements\": \"" << elements << "\",\n";
    trace.rules(rules);
    trace.boundary();
    out << ",\n\"advances\": [";
    while (out.ok() && stepper->position() < last && stepper->advance() == 1) {
        if (progress.cancelled()) {
            return error("cancelled", "the trace was cancelled");
        }
        out << (stepper->position() == 1 ? "\n" : ",\n");
        trace.advance();
    }
    out << "\n]}\n";
    return {};
}

} // namespace forefront
