#include "core/teaching/page/run_record.hpp"

#include "core/engine/base/number_text.hpp"
#include "core/teaching/moment/candidate_sides.hpp"
#include "core/teaching/moment/short_texts.hpp"

#include <concepts>
#include <cstddef>

namespace forefront {

namespace {

constexpr int kPlaceDigits = 8, kShareDigits = 4;

/// Writes a list of numbers; places within.
class NumberList {
  public:
    explicit NumberList(TextWriter &out) : out_(out) { out_ << '['; }
    ~NumberList() { out_ << ']'; }
    NumberList(const NumberList &) = delete;
    NumberList &operator=(const NumberList &) = delete;

    template <std::integral Integer>
    NumberList &add(Integer value) {
        next() << value;
        return *this;
    }
    NumberList &add(Vec2 place) {
        next() << numberText(place.x, kPlaceDigits) << ',' << numberText(place.y, kPlaceDigits);
        return *this;
    }

  private:
    TextWriter &next() {
        if (!first_) {
            out_ << ',';
        }
        first_ = false;
        return out_;
    }

    TextWriter &out_;
    bool first_ = true;
};

/// Returns an index for JSON; -1 for none.
std::int64_t numberOf(std::uint32_t index) {
    return index == kNoIndex ? -1 : static_cast<std::int64_t>(index);
}

/// Returns the part of a caption after "Edge 1-2: ", which the player writes itself.
std::string withoutEdge(const std::string &caption) {
    const std::size_t end = caption.find(": ");
    return end == std::string::npos ? caption : caption.substr(end + 2);
}

/// Writes what a square is: its short name, what it does, and its new sides as a line of places.
void writeSquare(TextWriter &out, const AdvanceExplanation &advance, const CandidateTrace &square) {
    out << ",\"name\":\"" << shortName(square) << "\",\"does\":\"" << squareText(square.square) << "\",\"sides\":";
    NumberList places(out);
    const std::vector<PlacedSide> sides = sidesOf(advance, square);
    places.add(sides.front()[0]);
    for (const PlacedSide &side : sides) {
        places.add(side[1]);
    }
}

void writeCandidate(TextWriter &out, const AdvanceExplanation &advance, const CandidateTrace &candidate) {
    out << "{\"node\":" << (candidate.node == kNoNode ? -1 : static_cast<std::int64_t>(index(candidate.node)));
    if (candidate.node == kNoNode) {
        out << ",\"at\":";
        NumberList(out).add(candidate.position);
    }
    out << ",\"alpha\":" << numberText(candidate.alpha, kShareDigits)
        << ",\"ac\":" << numberText(candidate.deltaAC, kShareDigits)
        << ",\"cb\":" << numberText(candidate.deltaCB, kShareDigits)
        << ",\"score\":" << numberText(candidate.score, kShareDigits)
        << ",\"verdict\":" << static_cast<int>(candidate.verdict);
    if (candidate.square != SquareKind::None) {
        writeSquare(out, advance, candidate);
    }
    out << '}';
}

/// Writes a list of items, each by write(item).
template <class Range, class Write>
void writeList(TextWriter &out, const char *name, const Range &range, Write write) {
    out << ",\"" << name << "\":[";
    bool first = true;
    for (const auto &item : range) {
        out << (first ? "" : ",");
        first = false;
        write(item);
    }
    out << ']';
}

} // namespace

std::uint32_t WordList::add(const std::string &text) {
    const auto [found, isNew] = numbers_.try_emplace(text, static_cast<std::uint32_t>(words_.size()));
    if (isNew) {
        words_.push_back(text);
    }
    return found->second;
}

void RunRecord::nodes(std::span<const Vec2> nodes) {
    NumberList list(out_);
    for (const Vec2 node : nodes) {
        list.add(node);
    }
}

void RunRecord::edges(const MeshView &mesh) {
    NumberList list(out_);
    for (const TaggedEdge &edge : mesh.edges) {
        list.add(index(edge.a)).add(index(edge.b));
    }
}

void RunRecord::cells(const MeshView &mesh, unsigned width) {
    NumberList list(out_);
    for (std::size_t e = 0; e < mesh.elementCount(); ++e) {
        const std::span<const NodeId> corners = mesh.cornersOf(e);
        for (unsigned k = 0; k < width; ++k) {
            list.add(k < corners.size() ? static_cast<std::int64_t>(index(corners[k])) : std::int64_t{-1});
        }
    }
}

void RunRecord::elements(const AdvanceExplanation &advance, std::span<const Element> triangles) {
    NumberList list(out_);
    for (std::size_t k = 0; k < advance.elements; ++k) {
        for (const NodeId node : triangles[index(advance.element) + k]) {
            list.add(index(node));
        }
    }
}

void RunRecord::advance(const AdvanceExplanation &advance, std::span<const Element> triangles, WordList &words) {
    out_ << "{\"base\":";
    NumberList(out_).add(index(advance.nodeA)).add(index(advance.nodeB));
    out_ << ",\"rho\":" << numberText(advance.rho, kPlaceDigits) << ",\"c\":";
    NumberList(out_).add(advance.ideal);
    out_ << ",\"radius\":" << numberText(advance.searchRadius, kPlaceDigits);
    writeList(out_, "candidates", advance.candidates,
              [&](const CandidateTrace &c) { writeCandidate(out_, advance, c); });
    writeList(out_, "tests", advance.tests, [&](const TestTrace &t) {
        NumberList list(out_);
        list.add(t.candidate).add(t.candidateFrom).add(t.candidateTo).add(t.frontA).add(t.frontB).add(t.meets ? 1 : 0);
    });
    out_ << ",\"cells\":";
    {
        NumberList list(out_);
        for (const Box2 &cell : advance.cells) {
            list.add(cell.min).add(cell.max);
        }
    }
    out_ << ",\"elements\":";
    elements(advance, triangles);
    std::size_t number = 0;
    writeList(out_, "events", advance.events, [&](const TraceEvent &event) {
        NumberList list(out_);
        list.add(static_cast<int>(event.step)).add(numberOf(event.candidate)).add(numberOf(event.test));
        list.add(event.cellsSeen).add(event.candidatesSeen).add(event.delivered);
        list.add(words.add(withoutEdge(caption(advance, number++))));
    });
    out_ << ",\"outcome\":" << words.add(withoutEdge(caption(advance, advance.events.size()))) << '}';
}

} // namespace forefront
