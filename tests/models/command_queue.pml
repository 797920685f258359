// The command queue (UntypedQueueWriter and UntypedQueueReader of msgclient/include/gaitway/msgclient/handles.hpp
// over the ring): one writer, one reader, each killed before any of its steps and followed by another one.
//
// Shown: what is popped is whole, in the order of the pushes, and no push twice; a push is refused exactly when
// the writer sees SLOTS values that wait, and is then not there; what was pushed waits, was popped, or went down
// with a reader that was killed while it had it in its hands: at most one for each killed reader.
#ifndef SLOTS
#define SLOTS 2
#endif
#ifndef PUSHES
#define PUSHES 4
#endif
#ifndef WORDS
#define WORDS 2
#endif
#ifndef WRITER_KILLS
#define WRITER_KILLS 1
#endif
#ifndef READER_KILLS
#define READER_KILLS 1
#endif
#define PARTIES 2
#define WRITER 0
#define READER 1
#define LOG ((PUSHES + WRITER_KILLS) * (WORDS + 3))
#define PUBLISHED 0
#define SEQUENCE(slot) (1 + (slot))
#define WORD(slot, i) (1 + SLOTS + (slot) * WORDS + (i))
#define TAKEN 0
#define PLACES (1 + SLOTS + SLOTS * WORDS)
#include "memory.pml"

byte writer_kills = WRITER_KILLS;
byte reader_kills = READER_KILLS;
byte lost_with_readers;        // values
bool in_hand;                  // taken and not yet handed to the caller
byte published;                // by the writers' own account
byte taken;                    // by the readers' own account
byte pushed[PUSHES + 2];       // [sequence]: number of the push that was published under it
bool popped[PUSHES + 1];       // [number of a push]

active proctype writer() {
  View view;
  byte entry, newer;
  byte number = 1;  // of the push; a killed one is not repeated: its successor doesn't know of it
  byte seen_taken, n, i;
begin:
  do
  :: number <= PUSHES ->
     atomic { OR_KILLED(writer_kills); load(READER, view, TAKEN, ACQUIRE, seen_taken) }          // model: push.1
     if
#ifdef MUTATION_FULL_TOO_LATE
     :: published - seen_taken > SLOTS ->
#else
     :: published - seen_taken >= SLOTS ->
#endif
        assert(published - seen_taken == SLOTS)  // refused, and the caller is told
     :: else ->
        atomic { OR_KILLED(writer_kills); n = published + 1;
                 store(WRITER, SEQUENCE(n % SLOTS), 0, RELAXED) }                               // model: publish.1
        do
        :: i < WORDS ->
           atomic { OR_KILLED(writer_kills);
                    store(WRITER, WORD(n % SLOTS, i), number, RELEASE); i++ }                   // model: publish.2
        :: else -> break
        od;
        i = 0;
        atomic { OR_KILLED(writer_kills); store(WRITER, SEQUENCE(n % SLOTS), n, RELEASE) }      // model: publish.3
        atomic { OR_KILLED(writer_kills); store(WRITER, PUBLISHED, n, RELEASE);                 // model: publish.4
                 published = n; pushed[n] = number; n = 0 }
     fi;
     atomic { OR_KILLED(writer_kills); number++; seen_taken = 0 }
  :: else -> break
  od;
  goto done;
killed:
  atomic { number++; seen_taken = 0; n = 0; i = 0 }  // its successor sees what it saw
  goto begin;
done:
}

active proctype reader() {
  View view;
  byte entry, newer;
  byte newest, next, sequence, value, word, i;
  byte last;                   // number of the push that was popped last
  bool is_torn;
begin:
  do
  :: atomic { OR_KILLED(reader_kills); load(WRITER, view, PUBLISHED, ACQUIRE, newest) }         // model: pop.1
     assert(newest - taken <= SLOTS);  // else the writer broke the rules
     if
     :: taken == newest
     :: taken != newest ->
        next = taken + 1;
#ifdef MUTATION_TAKEN_FIRST
        atomic { OR_KILLED(reader_kills); store(READER, TAKEN, next, RELEASE); taken = next; in_hand = true }
#endif
        atomic { OR_KILLED(reader_kills);
                 load(WRITER, view, SEQUENCE(next % SLOTS), ACQUIRE, sequence) }                // model: read.2
        assert(sequence == next);  // never overtaken, never half-written
        do
        :: i < WORDS ->
           atomic { OR_KILLED(reader_kills);
                    load(WRITER, view, WORD(next % SLOTS, i), ACQUIRE, word);                   // model: read.3
                    is_torn = is_torn || (i > 0 && word != value);
                    value = word; word = 0; i++ }
        :: else -> break
        od;
        i = 0;
        atomic { OR_KILLED(reader_kills);
                 load(WRITER, view, SEQUENCE(next % SLOTS), RELAXED, sequence) }                // model: read.4
        assert(sequence == next && !is_torn);
#if !defined(MUTATION_TAKEN_FIRST) && !defined(MUTATION_TAKEN_LAST)
        atomic { OR_KILLED(reader_kills); store(READER, TAKEN, next, RELEASE); taken = next; in_hand = true }   // model: pop.2
#endif
        atomic { OR_KILLED(reader_kills);
                 assert(value == pushed[next]);
                 assert(!popped[value] && value > last);
                 popped[value] = true; last = value; in_hand = false;
                 value = 0; sequence = 0 }
#ifdef MUTATION_TAKEN_LAST
        atomic { OR_KILLED(reader_kills); store(READER, TAKEN, next, RELEASE); taken = next }
#endif
        next = 0
     fi;
     newest = 0
  od;
killed:
  atomic {
    if
    :: in_hand -> lost_with_readers++; in_hand = false
    :: else
    fi;
    newest = 0; next = 0; sequence = 0; value = 0; word = 0; i = 0; is_torn = false;
    goto begin
  }
}

// At any instant: what was taken has been popped, but for what went down with readers, and for what the reader
// has in its hands.
active proctype judge() {
  byte n, missing;
  d_step {
    n = 1;
    do
    :: n <= taken ->
       if
       :: !popped[pushed[n]] -> missing++
       :: else
       fi;
       n++
    :: else -> break
    od;
    assert(missing == lost_with_readers + in_hand);
    assert(lost_with_readers <= READER_KILLS - reader_kills);
    n = 0; missing = 0
  }
}
