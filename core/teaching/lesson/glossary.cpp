#include "core/teaching/lesson/glossary.hpp"

#include "core/engine/base/letter_case.hpp"
#include "core/teaching/lesson/glossary_figures.hpp"

#include <algorithm>
#include <cctype>
#include <string>

namespace forefront {

namespace {

const std::vector<GlossaryTerm> kTerms = {
    {"domain",
     "Domain \xce\xa9 and its boundary",
     {"domain", "boundary segment"},
     "The region to be meshed. Before meshing, its boundary is divided into segments as long as \xcf\x81 there; with "
     "\"Keep segments\", the drawn segments are used as they are. Each has the domain to its left, so that outer loops "
     "run "
     "counter-clockwise and holes clockwise. The front starts from these segments, and they become edges of the mesh.",
     {"front", "spacing"},
     figures::domain},
    {"spacing",
     "Node spacing function \xcf\x81",
     {"spacing", "\xcf\x81"},
     "The edge length that is asked for at each point. It comes from a size or formula you enter, from size sources "
     "and from "
     "brush strokes; the smallest of them wins.",
     {"gradation", "conformity"},
     figures::spacing},
    {"front",
     "Generation front \xce\x93",
     {"front"},
     "The directed segments between the meshed and the unmeshed part of the domain. At the start it is the boundary. "
     "Each element removes segments from it and adds others. When it is empty, the mesh is complete.",
     {"base", "closing"},
     figures::front},
    {"base",
     "Base segment AB",
     {"base"},
     "The segment of the front that the next element is built on. The classic method takes the shortest one, so that "
     "large elements never disturb small ones. Of several that are equally short, apart from rounding, it takes the "
     "one that joined the front first. The unmeshed part lies to the left of AB.",
     {"ideal-point", "deferral"},
     figures::base},
    {"ideal-point",
     "Ideal point C",
     {"ideal point"},
     "The third corner, or apex, that would give the best element on AB: on the perpendicular bisector of AB, to the "
     "left of AB, and normally \xcf\x81 away from A and B. It becomes a new node if nothing on the front is too "
     "near.",
     {"base", "candidates", "spacing"},
     figures::idealPoint},
    {"candidates",
     "Candidate nodes",
     {"candidate"},
     "The nodes that could be the apex of the next element: the ideal point, and the nodes of the front within a "
     "circle "
     "around it. They are tried in the order of their scores.",
     {"ideal-point", "score", "rejection"},
     figures::candidates},
    {"candidate-segments",
     "Candidate segments AC and CB",
     {"candidate segment"},
     "The two sides that a new element would have besides AB. They must not cross the front; the intersection tests "
     "check this.",
     {"candidates", "neighbours", "rejection"},
     figures::candidateSegments},
    {"score",
     "Score of a candidate",
     {"score"},
     "The product \xce\xb1(ABC) \xc2\xb7 \xce\xb4(AC) \xc2\xb7 \xce\xb4(CB): 1 for an equilateral triangle whose sides "
     "have exactly the length \xcf\x81, less "
     "for any other.",
     {"shape-factor", "conformity"},
     figures::score},
    {"shape-factor",
     "Shape factor \xce\xb1",
     {"shape factor", "\xce\xb1"},
     "4\xe2\x88\x9a"
     "3 times the area of a triangle, divided by the sum of the squares of its sides. 1 for an equilateral "
     "triangle, 0 for a flat one, whose corners lie on a line, and negative for one whose corners A, B and C go round "
     "clockwise.",
     {"score", "improvement"},
     figures::shapeFactor},
    {"conformity",
     "Spacing conformity \xce\xb4",
     {"conformity", "\xce\xb4"},
     "How well the length L of a segment agrees with the spacing \xcf\x81 at its midpoint: the smaller of L/\xcf\x81 "
     "and "
     "\xcf\x81/L, so 1 at best. For a mesh: the mean over its edges.",
     {"score", "spacing"},
     figures::conformity},
    {"grid",
     "Background grid",
     {"background grid", "grid"},
     "Cells that know which segments of the front cross them, so that a search looks at nearby segments only. A "
     "hierarchical grid splits its cells where segments are short. The grid affects speed, never the mesh.",
     {"neighbours", "counters"},
     figures::grid},
    {"neighbours",
     "Neighbouring segments",
     {"neighbouring segment", "nearby segment"},
     "The segments of the front that the background grid returns for a region. The fewer there are, the fewer have to "
     "be tested.",
     {"grid", "counters"},
     figures::neighbours},
    {"counters",
     "Nn, Ne, Nb, Nc, Ns, Nt",
     {"nb", "nc", "ns", "nt"},
     "Nn is the number of nodes, Ne the number of elements. The others are averages over a run: Nb is the number of "
     "segments on the front. The others count segments for each element: Nc those that the grid returns; Ns those "
     "near enough to be considered, which reach into the search region, once for AC and once for CB; Nt those of them "
     "that are tested exactly. Lo prints Nb, Nc and Ns.",
     {"grid", "neighbours"},
     figures::neighbours},
    {"rejection",
     "Rejected candidate",
     {"reject"},
     "A candidate fails if the triangle would have no area, if AC or CB would cross the front or leave the unmeshed "
     "part, or if the triangle would contain a node of the front. Then the next one is tried.",
     {"candidate-segments", "deferral"},
     figures::rejection},
    {"deferral",
     "Deferred base",
     {"defer"},
     "If no candidate passes, the base is put back and waits until only deferred bases are left; then it is tried "
     "again "
     "with a wider search. In the meantime an element on another base may have covered it.",
     {"base", "closing"},
     figures::deferral},
    {"closing",
     "Closing",
     {"closing", "close the front", "last element"},
     "The last stage: only deferred bases are left, and they are tried again with a wider search. If one fails again, "
     "its search is widened until an existing node passes, which is always possible in the plane; an element made in "
     "this way counts as forced.",
     {"front", "deferral"},
     figures::closing},
    {"gradation",
     "Gradation",
     {"gradation"},
     "A limit on how fast the spacing grows with distance, so that small and large elements do not meet abruptly.",
     {"spacing"},
     figures::gradation},
    {"methods",
     "Classic and fast methods",
     {"classic", "fast method"},
     "The classic method follows Lo's ten steps: the shortest base first, one element per advance. The fast method "
     "walks "
     "along the front, and a new node makes up to three elements at once.",
     {"base", "front"},
     figures::methods},
    {"improvement",
     "Improvement",
     {"improve", "smoothing", "swap"},
     "After the front is closed, edges are swapped and nodes moved where this improves the worst angles.",
     {"shape-factor"},
     figures::improvement},
    {"schoenhardt",
     "Sch\xc3\xb6nhardt's prism",
     {"sch\xc3\xb6nhardt"},
     "A prism with triangles at its bottom and top. Twist the top by 30 degrees, and each side folds inward along one "
     "of "
     "its diagonals; the other three diagonals now run outside. Any four of the six corners include the two ends of "
     "one "
     "of these, so no tetrahedron with its corners fits inside, and the solid cannot be divided without a new node.",
     {"closing"},
     figures::schoenhardt},
    {"adaptation",
     "Adapted spacing",
     {"adapt"},
     "A spacing that follows from the error of a field. Between the nodes, each element replaces the field by a plane; "
     "the error is large where the field bends within an element. Small elements there, and large ones elsewhere, give "
     "a smaller error with as many elements.",
     {"spacing", "gradation"},
     figures::adaptation},
    {"strips",
     "Strips",
     {"strip"},
     "Parts of the plane in which threads advance the front of a large mesh at the same time. A base whose search "
     "stays "
     "inside its strip is taken now. One whose search crosses a seam waits for other strips, which lie over the seams.",
     {"methods", "front"},
     figures::strips},
};

bool isWordPart(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0;
}

/// Returns true if a text contains a phrase at the start of a word. A phrase of two letters must match a whole word.
bool speaksOf(const std::string &text, std::string_view phrase) {
    for (std::size_t at = text.find(phrase); at != std::string::npos; at = text.find(phrase, at + 1)) {
        const std::size_t end = at + phrase.size();
        const bool begins = at == 0 || !isWordPart(text[at - 1]);
        const bool ends = phrase.size() > 2 || end == text.size() || !isWordPart(text[end]);
        if (begins && ends) {
            return true;
        }
    }
    return false;
}

} // namespace

std::span<const GlossaryTerm> glossary() {
    return kTerms;
}

const GlossaryTerm *glossaryTerm(std::string_view id) {
    const auto found = std::find_if(kTerms.begin(), kTerms.end(), [id](const auto &term) { return term.id == id; });
    return found == kTerms.end() ? nullptr : &*found;
}

std::vector<const GlossaryTerm *> termsIn(std::string_view text) {
    const std::string lower = lowerCase(text);
    std::vector<const GlossaryTerm *> found;
    for (const GlossaryTerm &term : kTerms) {
        const bool spoken = std::any_of(term.phrases.begin(), term.phrases.end(),
                                        [&](std::string_view phrase) { return speaksOf(lower, phrase); });
        if (spoken) {
            found.push_back(&term);
        }
    }
    return found;
}

} // namespace forefront
