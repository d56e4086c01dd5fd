#pragma once

#include "core/engine/base/progress.hpp"
#include "core/engine/base/result.hpp"
#include "core/files/source/source.hpp"
#include "core/teaching/lesson/lesson.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace forefront {

class LessonRuns;

/// An answer as a learner gave it: the text of a choice, a number as it was typed, or "advance N" for a task.
struct GivenAnswer {
    std::string text;
    bool right = false;
};

/// The answers to the question of a page, in the order in which they were given.
struct PageAnswers {
    std::string title;    ///< of the page
    std::string question; ///< empty: the page has none
    std::vector<GivenAnswer> answers;
    bool shown = false;  ///< Show me was asked before there was a right answer
    LessonPlace place{}; ///< in the file
};

/// The answers of a learner to the questions of a lesson, as a file of them holds them.
struct LessonAnswers {
    std::string lesson;     ///< its title
    std::uint64_t seed = 0; ///< of its random numbers; 0: it has none
    std::vector<PageAnswers> pages;
    std::string edition{}; ///< differs between versions of the lesson; empty: unknown
};

/// How many questions have a right answer, and how many others were shown.
struct AnswerCount {
    std::size_t answered = 0, shown = 0;
};

/// Returns true if one of the answers to the question of a page is right.
bool hasRightAnswer(const PageAnswers &page);
AnswerCount countAnswers(const LessonAnswers &answers);
/// Returns no answers to the questions of a lesson.
LessonAnswers noAnswers(const Lesson &lesson);
/// Returns true if there is an answer to any question, or one was shown.
bool hasAnswers(const LessonAnswers &answers);
/// Adds answers that were given elsewhere meanwhile: `given` and `others` both continue `kept`. Those of `others` come
/// first. Returns false if they belong to other random numbers or another version of the lesson; nothing is changed
/// then.
bool mergeAnswers(LessonAnswers &given, const LessonAnswers &kept, const LessonAnswers &others);
/// Returns the answers as a file: JSON, as assets/lessons/README.md describes it.
std::string answersText(const LessonAnswers &answers);
/// Reads such a file, of the editor or of a page. Faults carry their place in the source.
Result<LessonAnswers> readAnswers(const SourceText &source);

/// Returns the answer that a state of a run is to a task, such as "advance 12". Steps of the improvement count on.
std::string taskAnswer(const SessionSnapshot &run);
/// Returns the wrong choice of a candidate as an answer, such as "candidate 2"; a right one is recorded by its advance.
std::string candidateAnswer(std::size_t candidate);

/// How well the answers do.
struct AnswerScore {
    std::size_t questions = 0;        ///< of the lesson
    std::size_t answered = 0;         ///< questions with a right answer
    std::size_t firstTry = 0;         ///< questions whose first answer is right
    std::vector<std::string> lines{}; ///< a line for each question: its page, and what was answered
};

/// Checks answers against the lesson that they belong to, read with their seed, and reports its progress after each
/// answer. `source`: the file of the answers. Errors: "other-lesson", "other-answer" (not one of the choices, or not a
/// number), "false-claim" (an answer is not what the file says of it), "too-large" (more than 1,000 answers to a
/// question), those of the runs, "cancelled".
Result<AnswerScore> checkAnswers(const LessonAnswers &answers, const SourceText &source, const Lesson &lesson,
                                 LessonRuns &runs, const Progress &progress);

} // namespace forefront
