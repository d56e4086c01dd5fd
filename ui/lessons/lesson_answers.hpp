#pragma once

#include <functional>
#include <string>

namespace forefront {

struct LessonEntry;
struct Shell;

// The answers of a learner to the open lesson, and its random numbers.

/// Records an answer to the question of the page.
void recordAnswer(Shell &context, std::string text, bool right);
/// Records that Show me was asked for the page, unless its question was answered before.
void recordShown(Shell &context);
/// Shows the answer that was given to the question of the page before, once the run is where the page is about.
void restoreAnswer(Shell &context);
/// Returns true if there are answers to the lesson that is open, or was open last.
bool hasAnswersToSave(const Shell &context);
/// Asks for a file and writes the answers to the lesson that is open, or was open last.
void saveAnswers(Shell &context);
/// Asks for a file and writes the answers to a lesson.
void saveAnswersTo(Shell &context, const std::string &id);
/// Forgets the answers to the open lesson, after asking about those that are not saved, and shows its first page.
void forgetAnswers(Shell &context);
/// Runs `then`, which forgets the answers to the lesson of this entry, after asking if there are some that are not
/// saved. `why`: a sentence on why they would be forgotten; `verb`: of the button that forgets them.
void afterUnsavedAnswers(Shell &context, const LessonEntry &entry, const std::string &why, const std::string &verb,
                         std::function<void(Shell &)> then);
/// Runs `then`, after asking if there are answers that belong to another version of the lesson.
void afterEarlierAnswers(Shell &context, const LessonEntry &entry, std::function<void(Shell &)> then);
/// Reads the open lesson again with other random numbers, and shows the same page. Its answers are forgotten, after
/// asking about those that are not saved.
void chooseOtherNumbers(Shell &context);

} // namespace forefront
