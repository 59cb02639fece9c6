#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/support/source_files.h"

namespace rob::test {

/// For each value that an object of a class holds, in the objects that it holds, too: the modules
/// that write it. "outputs", "press.state"; a value that nobody writes has an empty set.
using ChannelWriters = std::map<std::string, std::set<std::string>>;

/// Who among the files writes the values of a `root`, by their module_of(). Where what is held is
/// of a class that is among the files, too, its own members count, and a call of one of its methods
/// writes what the method does; it has to have its methods in its body. A value is written by an
/// assignment, and by the methods that write an atomic, a container or the end of a ring that is
/// the writer's. To take what was written is reading: pop(), take(), and exchange(), which leaves
/// the value that says that nothing is asked for.
///
/// Values are found by the names of references and pointers to the classes in question, which have
/// to differ from other names before the same members. A value that is passed on alone, by
/// reference or by its address, is not followed.
ChannelWriters channel_writers(const std::vector<SourceFile>& files, const std::string& root);

}  // namespace rob::test
