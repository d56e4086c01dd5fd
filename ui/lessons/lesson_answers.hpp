#pragma once

#include <functional>
#include <string>

namespace forefront {

struct LessonEntry;
struct Shell;

// The answers of a learner to the open lesson, and its random numbers.

/// Records an answer to the question of the page.
void recordAnswer(Shell &context, std::string text, bool right);
/// Returns true if a question of the open lesson was answered since the program started.
bool hasAnswersToSave(const Shell &context);
/// Asks for a file and writes the answers to the open lesson.
void saveAnswers(Shell &context);
/// Runs `then` unless the learner has answers to the lesson of this entry that are not saved and would be forgotten:
/// then asks first. `why`: a sentence on what they belong to; `verb`: of the button that forgets them.
void afterUnsavedAnswers(Shell &context, const LessonEntry &entry, const std::string &why, const std::string &verb,
                         std::function<void(Shell &)> then);
/// Reads the open lesson again with other random numbers, and shows the same page. Its answers are forgotten, after
/// asking about those that are not saved.
void chooseOtherNumbers(Shell &context);

} // namespace forefront
