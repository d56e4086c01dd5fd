#pragma once

#include "core/drawing/document/document.hpp"
#include "core/teaching/lesson/lesson_colours.hpp"
#include "core/teaching/lesson/lesson_formula.hpp"
#include "core/teaching/lesson/lesson_picture.hpp"
#include "core/teaching/lesson/lesson_value.hpp"
#include "core/teaching/lesson/random_numbers.hpp"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace forefront {

/// A line and column in the file of a lesson; 0: unknown.
struct LessonPlace {
    int line = 0, column = 0;
};

/// A widget that a page outlines.
struct LessonHighlight {
    std::string widget; ///< its name
    LessonPlace place{};
};

/// A position of the timeline.
struct LessonPosition {
    bool atEnd = false;        ///< the finished and improved mesh; the rest is ignored
    std::uint64_t advance = 0; ///< advances done
    std::int64_t events = 0;   ///< moments shown of the next advance
    bool random = false;       ///< `advance` is a random number
    LessonPlace place{};       ///< in the file

    friend bool operator==(const LessonPosition &a, const LessonPosition &b) {
        return a.atEnd == b.atEnd && a.advance == b.advance && a.events == b.events;
    }
};

/// The view of the camera.
struct LessonCamera {
    bool follow = false;     ///< the current advance
    std::optional<Box2> box; ///< this part of the plane; otherwise the whole drawing
};

/// The values of α at the ends of the colour scale.
struct LessonRange {
    double from = 0.0, to = 1.0; ///< from < to
};

/// A question answered by choosing one of several texts.
struct LessonChoices {
    struct Choice {
        std::string text;
        bool right = false;                  ///< if there is no condition
        std::vector<LessonCondition> when{}; ///< right if the run fulfils all of them
        std::string hint{};                  ///< shown after this choice if it is wrong; empty: that of the question
    };
    std::vector<Choice> list;
};

/// A question answered by a number.
struct LessonNumber {
    /// A wrong number that learners confuse with the right one, and its hint.
    struct Mistake {
        LessonFormula value;
        std::string hint;
    };

    LessonFormula value;
    std::optional<double> within{}; ///< largest difference from the value; not set: as far as people round it
    double percent = 0.0;           ///< or this many per cent of the value, if that is more
    std::vector<Mistake> mistakes{};
};

/// A task: bring the run into a state that fulfils all conditions.
struct LessonTask {
    std::vector<LessonCondition> until;
};

/// A question of a page. Choices and numbers are about the run at the position of the page, tasks about the run as it
/// is.
struct LessonQuestion {
    std::string text;
    std::variant<LessonChoices, LessonNumber, LessonTask> answer;
    std::string hint;                     ///< shown after a wrong answer; may be empty
    std::string why;                      ///< shown after the right answer; may be empty
    std::optional<LessonPosition> show{}; ///< where the run shows the answer
    LessonPlace place{};                  ///< in the file
};

/// A page of a lesson with the scene that it shows. Members that a page omits keep their values from the page before.
struct LessonPage {
    std::string title;
    std::vector<std::string> paragraphs; ///< may contain markup, see parseMarkup(), and values, see withValues()
    std::shared_ptr<const Document> document;
    std::string documentName;
    std::optional<Method> method;        ///< instead of that of the document
    std::optional<GridKind> grid;        ///< instead of that of the document
    std::optional<ImproveLevel> improve; ///< instead of that of the document
    std::optional<FrontRules> rules;     ///< instead of those of the document
    LessonPosition position;
    std::optional<std::vector<std::string>> layers; ///< ids of the visible layers; not set: as they are
    std::string panel;                              ///< id of the panel to show; empty: as it is
    LessonCamera camera;
    std::optional<LessonRange> range;        ///< not set: it fits the mesh
    LessonColours colours;                   ///< of the layer "quality"
    std::vector<LessonHighlight> highlights; ///< on this page only
    std::optional<LessonQuestion> question;
    bool random = false; ///< other random numbers change its position, texts or question
};

/// The pictures that the texts of a lesson show, by their files relative to the lesson.
using LessonPictures = std::map<std::string, std::shared_ptr<const LessonPicture>>;

/// A lesson about the advancing front: pages of text, each with a scene to explore and perhaps a question.
struct Lesson {
    std::string title;
    std::string about; ///< what it teaches, in a sentence
    std::vector<LessonPage> pages;
    std::uint64_t seed = 0;            ///< of its random numbers; 0: it has none
    std::vector<RandomRange> random{}; ///< the ranges that it draws from
    LessonPictures pictures{};         ///< those that cannot be shown have faults
};

/// Returns the page that a link leads to by its number, counted from 1, or its title; nothing if there is none.
std::optional<std::size_t> pageOfTarget(const Lesson &lesson, std::string_view target);
/// Returns why pictures of a lesson cannot be shown, with their places in the file of the lesson. `decode`: also
/// decodes them, which takes a while.
Diagnostics pictureFaults(const Lesson &lesson, const std::string &file, bool decode);

/// Returns the number of pages with a question.
std::size_t questionsOf(const Lesson &lesson);

/// Returns the document of a page with the method, grid, improvement level and rules of the page.
std::shared_ptr<const Document> documentOf(const LessonPage &page);

/// Returns true if the answer of a question is choice `index`.
bool isRight(const LessonChoices &choices, std::size_t index, const LessonState &state);
/// Returns true if a number answers a question.
bool isRight(const LessonNumber &question, double number, const LessonState &state);
/// Returns the largest difference of a right answer from the value.
double toleranceOf(const LessonNumber &question, const LessonState &state);
/// Returns the difference from a number by which people round it: to three significant digits; a whole number not at
/// all.
double roundingOf(double number);

/// A mistake of a question, in a state in which it has a number.
struct KnownMistake {
    double number = 0.0;
    double within = 0.0; ///< largest difference of an answer that makes this mistake
    const std::string *hint = nullptr;
};
/// Returns the mistakes that a question knows. An answer makes the first that it is near enough to.
std::vector<KnownMistake> mistakesOf(const LessonNumber &question, const LessonState &state);
/// Returns the number that an answer of a learner is, with a point or a comma; nothing if it is none.
std::optional<double> answeredNumber(std::string text);
/// Returns the hint after a wrong choice or number: that of the answer, or else that of the question. May be empty.
const std::string &hintAfter(const LessonQuestion &question, std::size_t choice);
const std::string &hintAfter(const LessonQuestion &question, double number, const LessonState &state);
/// Returns true if the task is done.
bool isDone(const LessonTask &task, const LessonState &state);
/// Returns true if the answer of a question depends on the run.
bool asksAboutRun(const LessonQuestion &question);
/// Returns true if the task is to choose a candidate.
bool asksForCandidate(const LessonTask &task);
/// Returns true if a condition of the task needs a snapshot with its mesh, see needsMesh().
bool asksForMesh(const LessonTask &task);

} // namespace forefront
