// Which entry of which blackboard each port means, and of which type it is, once sub-trees are put in.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "definitions.hpp"
#include "gaitway/behaviour/description.hpp"

namespace gaitway::behaviour {

using ScopeIndex = std::size_t;  // 0: the main tree's blackboard

class BlackboardLayout {
 public:
  BlackboardLayout(Description& description, Complaints& complaints);

  // The blackboard of the SubTree node `node`, which is tree.nodes[defined], within that of `around`.
  ScopeIndex add_scope(ScopeIndex around, NodeIndex node, const Definition& tree, std::size_t defined);

  // The entry that a key means there; made if there is none.
  std::uint32_t entry(ScopeIndex scope, std::string_view key);

  // The port of `node` is connected with that entry and so says what it holds.
  void use(std::uint32_t entry, const PortSpec& spec, int line, NodeIndex node);
  // One is copied into the other: they have one type.
  void unite(std::uint32_t a, std::uint32_t b);
  // The binding `binding` gets a constant whose type is that of the entry (text, where there is none).
  void write_later(std::size_t binding, std::int64_t typed_by, const PortText& text, std::string_view field,
                   NodeIndex node);

  // Types entries, reads what waits for a type, complains about what does not fit.
  void finish();

 private:
  struct Remap {
    const Remapping* remapping;
    bool used = false;
  };
  struct Scope {
    ScopeIndex around = 0;
    NodeIndex node = kNoNode;
    bool autoremap = false;
    const Definition* tree = nullptr;
    std::size_t defined = 0;
    std::map<std::string, std::uint32_t, std::less<>> own{};
    std::map<std::string, Remap, std::less<>> remaps{};
  };
  struct Use {
    std::uint32_t entry;
    const PortSpec* spec;
    int line;
    NodeIndex node;
  };
  struct Waiting {
    std::size_t binding;
    std::int64_t typed_by;
    std::string text;
    std::string field;
    int line;
    NodeIndex node;
  };
  struct Initial {
    std::uint32_t entry;
    const Remapping* remapping;
    ScopeIndex scope;
  };

  std::uint32_t make_entry(ScopeIndex scope, std::string_view key);
  std::uint32_t united(std::uint32_t entry);
  void narrow(ValueType& type, const Use& use, int first_line);
  void type_entries();
  void read_waiting();
  void read_initials();
  void check_remaps();
  // Complains where the text is no value of that type; paths are made only then.
  template <class Path>
  Value read(const std::string& text, const ValueType& type, int line, const Path& path,
             const std::string& field);

  Description& description_;
  Complaints& complaints_;
  std::vector<Scope> scopes_;
  std::vector<std::uint32_t> united_with_;
  std::vector<Use> uses_;
  std::vector<Waiting> waiting_;
  std::vector<Initial> initials_;
};

}  // namespace gaitway::behaviour
