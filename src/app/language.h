#pragma once

#include <QString>
#include <functional>

class QAction;

namespace gnathion {

/// The language of the window's words.
enum class Language {
  system,  ///< German on a German desktop, else English
  english,
  german,
};

/// The one that was chosen last: system where none was.
Language chosen_language();
/// Remembered; the windows that exist keep theirs, the next start of the program follows.
void choose_language(Language language);
/// As it was chosen last, for all words made from then on; to be called for each QCoreApplication
/// before a window is made. Numbers keep the decimal point in every language.
void start_language();
/// One of three actions, checked by what is chosen. `say` gets the words that tell the user when
/// a choice takes effect.
void connect_language_actions(QAction& system, QAction& english, QAction& german,
                              const std::function<void(const QString&)>& say);

}  // namespace gnathion
