#pragma once

#include <QString>
#include <string>

namespace gnathion {

/// What the core says in English (the stages of long work, notices, what is wrong and what to do,
/// the names of presets and landmarks) in the window's language; parts joined by "; " one by one.
/// What is not known here stays English: errors that name files, keys and faults of the program.
QString core_words(const QString& english);
QString core_words(const std::string& english);

}  // namespace gnathion
