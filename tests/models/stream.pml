// A stream (UntypedWriter and UntypedStreamReader of msgclient/include/gaitway/msgclient/handles.hpp over the
// ring, one slot more than its capacity): one writer that is killed before any of its steps and followed by
// another one, a reader that opens it at any instant, from the oldest value or the next one on.
//
// Shown: what is read is whole, in order, no value twice; each value after the opening is either read or counted
// as missed, once; none is counted that was among the newest CAPACITY when the reader looked.
#ifndef CAPACITY
#define CAPACITY 2
#endif
#ifndef VALUES
#define VALUES 5
#endif
#ifndef WORDS
#define WORDS 1
#endif
#ifndef KILLS
#define KILLS 1
#endif
#ifndef ATTEMPTS
#define ATTEMPTS 3
#endif
#define SLOTS (CAPACITY + 1)
#define PARTIES 1
#define WRITER 0
#define LOG ((VALUES + KILLS) * (WORDS + 3))
#define PUBLISHED 0
#define SEQUENCE(slot) (1 + (slot))
#define WORD(slot, i) (1 + SLOTS + (slot) * WORDS + (i))
#define PLACES (1 + SLOTS + SLOTS * WORDS)
#include "memory.pml"

#define PAYLOAD(writer, n) ((writer) * (VALUES + 1) + (n))

byte kills = KILLS;
byte published;
byte payload[VALUES + 1];

active proctype writer() {
  byte me, n, i;
begin:
  do
  :: published < VALUES ->
     atomic { OR_KILLED(kills); n = published + 1; store(WRITER, SEQUENCE(n % SLOTS), 0, RELAXED) }  // model: publish.1
     do
     :: i < WORDS ->
        atomic { OR_KILLED(kills);
                 store(WRITER, WORD(n % SLOTS, i), PAYLOAD(me, n), RELEASE); i++ }              // model: publish.2
     :: else -> break
     od;
     i = 0;
     atomic { OR_KILLED(kills); store(WRITER, SEQUENCE(n % SLOTS), n, RELEASE) }                // model: publish.3
     atomic { OR_KILLED(kills); store(WRITER, PUBLISHED, n, RELEASE);                           // model: publish.4
              published = n; payload[n] = PAYLOAD(me, n); n = 0 }
  :: else -> break
  od;
  goto done;
killed:
  atomic { me++; n = 0; i = 0 }
  goto begin;
done:
}

active proctype reader() {
  View view;
  byte entry, newer;
  byte next, first, missed, read;   // read: values that the caller got
  byte newest, oldest, sequence, value, word, i, attempt;
  bool is_torn;
  atomic {
    if
    :: next = 1
    :: load(WRITER, view, PUBLISHED, ACQUIRE, newest) -> next = newest + 1                      // model: stream_open.1
    fi;
    first = next; newest = 0
  }
  do
  :: atomic { attempt < ATTEMPTS -> load(WRITER, view, PUBLISHED, ACQUIRE, newest) }            // model: stream_read.1
     assert(next <= newest + 1);  // else the writer went back
     if
     :: next > newest
     :: else ->
#ifdef MUTATION_ALL_SLOTS
        oldest = (newest > SLOTS -> newest - SLOTS + 1 : 1);
#else
        oldest = (newest > SLOTS - 1 -> newest - (SLOTS - 1) + 1 : 1);
#endif
        if
        :: next < oldest ->
           atomic {                                                                             // model: stream_read.2
#ifdef MUTATION_ONE_MISSED
             missed++;
#else
             missed = missed + oldest - next;
#endif
             assert(oldest + CAPACITY == newest + 1);  // of the newest CAPACITY, none is given up
             next = oldest
           }
        :: else
        fi;
        assert(next + CAPACITY > newest);  // what may be overwritten at this moment is not tried
        atomic { load(WRITER, view, SEQUENCE(next % SLOTS), ACQUIRE, sequence) }                // model: read.2
        if
        :: sequence == next ->
           do
           :: i < WORDS ->
              atomic { load(WRITER, view, WORD(next % SLOTS, i), ACQUIRE, word);                // model: read.3
                       is_torn = is_torn || (i > 0 && word != value);
                       value = word; word = 0; i++ }
           :: else -> break
           od;
           atomic { i = 0; load(WRITER, view, SEQUENCE(next % SLOTS), RELAXED, sequence) }      // model: read.4
        :: else
        fi;
        atomic {
          if
          :: sequence == next ->
             assert(!is_torn && value == payload[next]);
             next++; read++; attempt = 0
          :: else -> attempt++  // overtaken: looks again
          fi;
          value = 0; sequence = 0; is_torn = false; oldest = 0
        }
     fi;
     atomic { newest = 0; assert(read + missed == next - first) }
  :: attempt == ATTEMPTS -> attempt = 0                                                         // told as overtaken
  :: next == VALUES + 1 -> break
  od;
  assert(published == VALUES && read + missed == VALUES + 1 - first)
}
