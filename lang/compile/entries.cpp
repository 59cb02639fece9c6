#include "lang/compile/entries.h"

#include <algorithm>
#include <set>
#include <utility>

#include "lang/text/ascii.h"

namespace rob::lang {

namespace {

DeclaredName::Kind kind_of(const Symbol& symbol) {
  switch (symbol.kind) {
    case Symbol::Kind::NamedConstant:
      return DeclaredName::Kind::Const;
    case Symbol::Kind::Point:
      return DeclaredName::Kind::Point;
    case Symbol::Kind::Signal:
      return DeclaredName::Kind::Signal;
    case Symbol::Kind::Routine:
      return DeclaredName::Kind::Routine;
    case Symbol::Kind::Record:
    case Symbol::Kind::Enum:
      return DeclaredName::Kind::Record;
    default:
      return DeclaredName::Kind::Variable;
  }
}

DeclaredName declared(const Symbol& symbol) {
  return {kind_of(symbol), symbol.name, in_words(symbol.type), symbol.place};
}

/// In capitals; those in texts and comments, too.
std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t i = 0; i < text.size();) {
    std::size_t end = i;
    while (end < text.size() && in_word(text[end])) ++end;
    if (end > i) words.push_back(to_upper(text.substr(i, end - i)));
    i = end + 1;
  }
  return words;
}

/// Those that can mean something outside of the routine, each once.
std::vector<std::string> foreign_words(std::string_view text,
                                       const std::vector<std::string>& parameters) {
  std::vector<std::string> words = words_of(text);
  std::ranges::sort(words);
  const auto twice = std::unique(words.begin(), words.end());
  words.erase(twice, words.end());
  std::erase_if(words, [&](const std::string& word) {
    return std::ranges::any_of(parameters,
                               [&](const std::string& own) { return same_word(own, word); });
  });
  return words;
}

std::uint32_t count_lines(std::string_view text) {
  return static_cast<std::uint32_t>(std::ranges::count(text, '\n')) + 1;
}

/// Lines of a text, counted from 0, without the last line end.
std::string_view lines_of(std::string_view text, std::uint32_t first, std::uint32_t last) {
  std::size_t begin = 0;
  for (; first > 0; --first, --last) begin = text.find('\n', begin) + 1;
  std::size_t end = text.find('\n', begin);
  for (; last > 0 && end != std::string_view::npos; --last) end = text.find('\n', end + 1);
  return text.substr(begin, std::min(end, text.size()) - begin);
}

bool declares(const std::vector<KeptName>& names, const std::string& key) {
  return std::ranges::any_of(names,
                             [&](const KeptName& one) { return same_word(one.symbol.name, key); });
}

void sort_by_place(std::vector<DeclaredName>& names) {
  std::ranges::sort(names, [](const DeclaredName& a, const DeclaredName& b) {
    return comes_before(a.place, b.place);
  });
}

template <typename T, typename Which>
void erase(std::vector<T>& list, Which which) {
  const auto found = std::ranges::find_if(list, which);
  if (found != list.end()) list.erase(found);
}

}  // namespace

/// The names and texts that an entry is compiled with.
struct Entries::Selection {
  std::set<std::string> seen;  ///< words
  std::vector<const KeptName*> names;
  Users definitions;
};

const Entries::Known* Entries::known(const std::string& key) const {
  const auto found = known_.find(key);
  return found == known_.end() || found->second.empty() ? nullptr : &found->second.back();
}

/// Selects what the words name, and what that needs in turn.
void Entries::select(std::vector<std::string> words, Selection& selection) const {
  while (!words.empty()) {
    const std::string word = std::move(words.back());
    words.pop_back();
    if (!selection.seen.insert(word).second) continue;
    const Known* const known = this->known(word);
    if (known == nullptr) continue;
    if (known->definition == nullptr) {
      selection.names.push_back(known->name);
      add_frames(known->name->symbol.type, words);
    } else {
      selection.definitions.push_back(known->definition);
      const auto& more = known->definition->words;
      words.insert(words.end(), more.begin(), more.end());
    }
  }
}

/// The names of the FRAMEs that poses of the type are in.
void Entries::add_frames(const Type& type, std::vector<std::string>& words) const {
  if (type.detail == nullptr) return;
  if (type.has_row()) return add_frames(type.detail->element, words);
  for (const TypeDetail::Field& field : type.detail->fields) add_frames(field.type, words);
  const auto frame = frames_.find(type.detail);
  if (frame != frames_.end()) words.push_back(frame->second);
}

/// Whether a routine has not been declared anew since.
bool Entries::holds(const Definition& definition) const {
  const Known* const last = known(definition.routine);
  return last != nullptr && last->definition == &definition;
}

/// Routines that use what the entry declares anew must fit to it; false if all are selected.
bool Entries::select_users(const std::vector<KeptName>& names, Selection& selection) const {
  bool more = false;
  for (const KeptName& name : names) {
    const auto users = users_.find(to_upper(name.symbol.name));
    if (users == users_.end()) continue;
    for (const Definition* const user : users->second) {
      if (!holds(*user) || declares(names, user->routine)) continue;
      if (std::ranges::find(selection.definitions, user) != selection.definitions.end()) continue;
      more = true;
      selection.definitions.push_back(user);
      select(user->words, selection);
    }
  }
  return more;
}

EntryText Entries::text_of(Selection selection, std::string_view entry) const {
  EntryText text;
  text.line = line_;
  text.rooms.now = room_;
  text.types = std::make_shared<TypeTable>();
  text.types->joints = types_.joints;
  Users& definitions = selection.definitions;
  std::ranges::sort(definitions, {}, &Definition::first);
  const auto twice = std::unique(definitions.begin(), definitions.end());
  definitions.erase(twice, definitions.end());
  for (const Definition* const definition : definitions) {
    text.parts.push_back({text.source.size(), definition->first});
    text.source += definition->text + "\n";
    if (definition->use) text.rooms.before[definition->first] = definition->room;
  }
  text.parts.push_back({text.source.size(), line_});
  text.source.append(entry) += '\n';
  text.known = std::move(selection.names);
  for (const KeptName* const kept : text.known) {
    const std::pair key(0U, to_upper(kept->symbol.name));
    if (const auto found = types_.records.find(key); found != types_.records.end())
      text.types->records.insert(*found);
    if (const auto found = types_.frames.find(key); found != types_.frames.end())
      text.types->frames.insert(*found);
  }
  // Those of the files that are USEd are read again with them.
  const std::pair used(1U, std::string());
  text.types->records.insert(types_.records.lower_bound(used), types_.records.end());
  text.types->frames.insert(types_.frames.lower_bound(used), types_.frames.end());
  return text;
}

Compilation Entries::compile(std::string_view entry, const RobotSignature& robot,
                             const PointTable& points, const TargetJudge& judge,
                             const Sources* sources, Knowing knowing, As as) const {
  Selection selection;
  selection.definitions = uses_;
  std::vector<std::string> words = words_of(entry);
  words.insert(words.end(), tasks_.begin(), tasks_.end());
  for (const KeptName* const kept : safe_) words.push_back(to_upper(kept->symbol.name));
  // The points file may have a point in any FRAME.
  if (std::ranges::find(words, "POINT") != words.end())
    for (const auto& [detail, name] : frames_) words.push_back(name);
  if (knowing == Knowing::Everything)
    for (const auto& [name, list] : known_) words.push_back(name);
  select(std::move(words), selection);
  for (;;) {
    EntryText text = text_of(selection, entry);
    text.printed = as == As::Expression;
    Compilation compiled = lang::compile(text, robot, points, judge, sources);
    if (!compiled.chunk || !select_users(compiled.names, selection)) return compiled;
  }
}

void Entries::keep(std::string_view entry, const Compilation& compiled) {
  const std::uint32_t begin = std::exchange(line_, line_ + count_lines(entry));
  if (!compiled.chunk) return;
  const Room before = std::exchange(room_, compiled.room);
  if (compiled.names.empty() && compiled.definitions.empty() && compiled.shared.empty()) return;
  Entry kept{before, {compiled.names.begin(), compiled.names.end()}, {}, {}};
  keep_shared(compiled, kept);
  for (const Compilation::Definition& one : compiled.definitions) {
    const std::string_view text = lines_of(entry, one.first - begin, one.last - begin);
    kept.definitions.push_back({one.first, one.last, one.use, std::string(text),
                                foreign_words(text, one.parameters), before, to_upper(one.name)});
    if (one.task) tasks_.insert(to_upper(one.name));
  }
  types_.records.insert(compiled.types->records.begin(), compiled.types->records.end());
  types_.frames.insert(compiled.types->frames.begin(), compiled.types->frames.end());
  if (!compiled.types->details.empty()) tables_.push_back(compiled.types);
  add(entries_[begin] = std::move(kept));
}

void Entries::keep_shared(const Compilation& compiled, Entry& entry) {
  for (const Compilation::Shared& one : compiled.shared) {
    const Known* const found = known(to_upper(one.name->symbol.name));
    if (found == nullptr || found->name != one.name) continue;
    Symbol& symbol = found->name->symbol;
    entry.shared.push_back({found->name, symbol.shared, symbol.of_tasks});
    symbol.shared = true;
    symbol.of_tasks = one.of_tasks;
  }
}

void Entries::add(Entry& entry) {
  for (const Definition& definition : entry.definitions) {
    if (definition.use) uses_.push_back(&definition);
    if (definition.use) continue;
    for (const std::string& word : definition.words) users_[word].push_back(&definition);
  }
  for (KeptName& kept : entry.names) {
    const std::uint32_t line = kept.symbol.place.line;
    const auto definition = std::ranges::find_if(entry.definitions, [&](const Definition& one) {
      return !one.use && one.first <= line && line <= one.last;
    });
    const bool routine = kept.symbol.kind == Symbol::Kind::Routine;
    const std::string key = to_upper(kept.symbol.name);
    known_[key].push_back({&kept, routine ? &*definition : nullptr});
    if (kept.safe) safe_.push_back(&kept);
    if (kept.symbol.frame != nullptr) frames_[kept.symbol.frame] = key;
  }
}

void Entries::remove(const Entry& entry) {
  for (const Definition& definition : entry.definitions) {
    erase(uses_, [&](const Definition* one) { return one == &definition; });
    for (const std::string& word : definition.words)
      erase(users_[word], [&](const Definition* one) { return one == &definition; });
  }
  for (const KeptName& kept : entry.names) {
    const std::string key = to_upper(kept.symbol.name);
    erase(known_[key], [&](const Known& one) { return one.name == &kept; });
    erase(safe_, [&](const KeptName* one) { return one == &kept; });
    const Symbol::Kind kind = kept.symbol.kind;
    if (kind == Symbol::Kind::Record || kind == Symbol::Kind::Enum) types_.records.erase({0, key});
  }
}

void Entries::forget(std::uint32_t first, std::uint32_t last) {
  const auto begin = entries_.lower_bound(first);
  const auto end = entries_.upper_bound(last);
  if (begin == end) return;
  // The room is free again unless something lies after it.
  if (end == entries_.end()) room_ = begin->second.room;
  for (auto entry = end; entry != begin;) {
    --entry;
    for (const SharedBefore& before : entry->second.shared) {
      before.name->symbol.shared = before.shared;
      before.name->symbol.of_tasks = before.of_tasks;
    }
  }
  for (auto entry = begin; entry != end; ++entry) remove(entry->second);
  entries_.erase(begin, end);
}

bool Entries::forget(std::string_view name) {
  const std::string key = to_upper(name);
  const auto users = users_.find(key);
  if (users != users_.end() &&
      std::ranges::any_of(users->second, [&](const Definition* one) { return holds(*one); }))
    return false;
  known_.erase(key);
  return true;
}

std::optional<DeclaredName> Entries::find(std::string_view name) const {
  const Known* const found = known(to_upper(name));
  return found == nullptr ? std::nullopt : std::optional(declared(found->name->symbol));
}

std::vector<DeclaredName> Entries::names() const {
  std::vector<DeclaredName> names;
  for (const auto& [key, list] : known_)
    if (!list.empty()) names.push_back(declared(list.back().name->symbol));
  sort_by_place(names);
  return names;
}

std::vector<DeclaredName> Entries::named_in(std::string_view text) const {
  std::vector<DeclaredName> names;
  const std::vector<std::string> words = words_of(text);
  for (const std::string& word : std::set<std::string>(words.begin(), words.end()))
    if (const Known* const found = known(word)) names.push_back(declared(found->name->symbol));
  sort_by_place(names);
  return names;
}

}  // namespace rob::lang
