// The ring of a latest value (msgclient/include/gaitway/msgclient/ring.hpp, UntypedReader of handles.hpp): one
// writer that is killed before any of its steps and followed by another one, READERS readers that read again
// and again, each until ATTEMPTS tries were overtaken.
//
// Shown: what a reader gets is whole, was published under its sequence, and is never older than what it got
// before; a try fails only when SLOTS - 1 further values were published meanwhile, so a dead writer leaves its
// last whole value readable.
#ifndef SLOTS
#define SLOTS 2
#endif
#ifndef VALUES
#define VALUES 3
#endif
#ifndef WORDS
#define WORDS 2
#endif
#ifndef KILLS
#define KILLS 1
#endif
#ifndef READERS
#define READERS 1
#endif
#ifndef ATTEMPTS
#define ATTEMPTS 2
#endif
#define PARTIES 1
#define WRITER 0
#define LOG ((VALUES + KILLS) * (WORDS + 3))
#define PUBLISHED 0
#define SEQUENCE(slot) (1 + (slot))
#define WORD(slot, i) (1 + SLOTS + (slot) * WORDS + (i))
#define PLACES (1 + SLOTS + SLOTS * WORDS)
#include "memory.pml"

#ifdef MUTATION_RELAXED_WORDS
#define WORD_STORE RELAXED
#define WORD_LOAD RELAXED
#else
#define WORD_STORE RELEASE
#define WORD_LOAD ACQUIRE
#endif

// A writer's payload: which value it is of, and which writer wrote it.
#define PAYLOAD(writer, n) ((writer) * (VALUES + 1) + (n))

byte kills = KILLS;
byte published;            // by the writers' own account
byte payload[VALUES + 1];  // what was published under a sequence
byte begun;                // newest value whose slot has been touched

active proctype writer() {
  byte me;  // killed writers before this one
  byte n, i;
begin:
  do
  :: published < VALUES ->
#ifdef MUTATION_INDEX_FIRST
     atomic { OR_KILLED(kills); n = published + 1; store(WRITER, PUBLISHED, n, RELEASE); payload[n] = PAYLOAD(me, n) }
     atomic { OR_KILLED(kills); begun = n; store(WRITER, SEQUENCE(n % SLOTS), 0, RELAXED) }
#else
     atomic { OR_KILLED(kills); n = published + 1; begun = n;
              store(WRITER, SEQUENCE(n % SLOTS), 0, RELAXED) }                                  // model: publish.1
#endif
     do
     :: i < WORDS ->
        atomic { OR_KILLED(kills); store(WRITER, WORD(n % SLOTS, i), PAYLOAD(me, n), WORD_STORE); i++ }  // model: publish.2
     :: else -> break
     od;
     i = 0;
     atomic { OR_KILLED(kills); store(WRITER, SEQUENCE(n % SLOTS), n, RELEASE) }                       // model: publish.3
     atomic { OR_KILLED(kills);
#ifndef MUTATION_INDEX_FIRST
              store(WRITER, PUBLISHED, n, RELEASE);                                             // model: publish.4
#endif
              published = n; payload[n] = PAYLOAD(me, n); n = 0 }
  :: else -> break
  od;
  goto done;
killed:
  atomic { me++; n = 0; i = 0 }
  goto begin;  // or never, as far as the readers see
done:
}

active [READERS] proctype reader() {
  View view;
  byte entry, newer;
  byte last;               // sequence of what was read before
  byte p, sequence, value, i, word, attempt;
  bool is_torn;
  do
  :: attempt < ATTEMPTS ->
     atomic { load(WRITER, view, PUBLISHED, ACQUIRE, p) }                                       // model: read.1
     if
     :: p == 0 ->
        assert(last == 0)  // once there was a value, there is one
     :: else ->
        atomic { load(WRITER, view, SEQUENCE(p % SLOTS), ACQUIRE, sequence) }                   // model: read.2
        if
        :: sequence == p ->
           do
           :: i < WORDS ->
              atomic {
                load(WRITER, view, WORD(p % SLOTS, i), WORD_LOAD, word);                        // model: read.3
                is_torn = is_torn || (i > 0 && word != value);
                value = word; word = 0; i++
              }
           :: else -> break
           od;
           atomic { i = 0; load(WRITER, view, SEQUENCE(p % SLOTS), RELAXED, sequence) }         // model: read.4
        :: else
        fi;
#ifdef MUTATION_NO_SECOND_LOOK
        sequence = p;
#endif
        skip;
        d_step {
          if
          :: sequence == p ->
             assert(!is_torn);
             assert(value == payload[p]);
             assert(p >= last);
             last = p; attempt = 0
          :: else ->
             assert(begun >= p + SLOTS);  // overtaken: only by so many values
             attempt++
          fi;
          value = 0; sequence = 0; is_torn = false
        }
     fi;
     p = 0
  :: attempt == ATTEMPTS -> attempt = 0  // told as overtaken, the destination untouched
  od
}
