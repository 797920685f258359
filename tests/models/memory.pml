// Shared memory as C++ orders it, for models in which each place has one writer (a party and its successors).
//
// Each party's stores stand in a log, in the order of its program. A load may return any store that is not
// hidden: a store is hidden when the reader has already seen a newer one at that place (coherence), or when it
// has acquired a release store that stands behind a newer one in the log (happens-before). So a reader sees
// stores at different places in any order that release and acquire leave open, and as late as it likes; a
// relaxed load or store orders nothing but its own place. README.md says what this does not show.

typedef Log {
  byte length;
  byte place[LOG + 2];  // entry 0: what memory held at first, 0 everywhere
  byte value[LOG + 2];
  bool is_release[LOG + 2];
};
Log log[PARTIES];

// What one process knows of one party's log.
typedef View {
  byte acquired;      // everything up to here has happened before
  byte seen[PLACES];  // newest entry seen at a place; 0 when `acquired` says as much
};

#define RELAXED 0
#define RELEASE 1
#define ACQUIRE 1

inline store(party, where, what, order) {
  d_step {
    log[party].length++;
    assert(log[party].length <= LOG);
    log[party].place[log[party].length] = where;
    log[party].value[log[party].length] = what;
    log[party].is_release[log[party].length] = order;
  }
}

// Into `newer`: the next entry after `entry` at that place; 0: none.
inline find_newer(party, where) {
  newer = entry + 1;
  do
  :: newer > log[party].length -> newer = 0; break
  :: newer <= log[party].length && log[party].place[newer] == where -> break
  :: newer <= log[party].length && log[party].place[newer] != where -> newer++
  od;
  skip
}

// One load; inside `atomic`. The process has `byte entry, newer` and a View named `view`.
inline load(party, view, where, order, result) {
  d_step {
    entry = (view.seen[where] > view.acquired -> view.seen[where] : view.acquired);
    do
    :: entry > 0 && log[party].place[entry] != where -> entry--
    :: else -> break
    od;
    find_newer(party, where)
  }
  do
  :: break
  :: newer != 0 ->
     d_step {  // unreached where only one store can be seen
       entry = newer;
       find_newer(party, where)
     }
  od;
  skip;  // Spin allows no jump into a d_step
  d_step {
    result = log[party].value[entry];
    view.seen[where] = (entry > view.acquired -> entry : 0);
    if
    :: order == ACQUIRE && log[party].is_release[entry] && entry > view.acquired ->
       view.acquired = entry;
       newer = 0;
       do
       :: newer < PLACES ->
          if
          :: view.seen[newer] <= entry -> view.seen[newer] = 0
          :: else
          fi;
          newer++
       :: else -> break
       od
    :: else
    fi;
    entry = 0;
    newer = 0
  }
}

// Before a step: the process goes on, or is killed here and now while the budget lasts.
#define OR_KILLED(budget) \
  if \
  :: skip \
  :: budget > 0 -> budget--; goto killed \
  fi
