// Hand-overs and their answers through the EMI's window (msgclient/emi_host.cpp, emi_message.cpp): the main
// controller (host) posts at most one mail a cycle, the message controller takes it, judges it and answers.
// Either is killed before any of its steps and started again: a new host goes on with the same window, a new
// message controller has a new window, to which the host attaches when it has seen that the old one is dead.
// Doorbells get lost on both sides, and a bit of a mail is flipped.
//
// Shown: a mail that was taken is whole, or known as corrupt exactly when a bit was flipped; each that was taken
// is answered once, in order; when all is quiet, each mail has been taken and answered, and the host has every
// answer whose bell, or a later one, has rung; what is accepted is for later and later cycles, and not for
// earlier ones across a restart.
#ifndef CYCLES
#define CYCLES 2
#endif
#ifndef WORDS
#define WORDS 2
#endif
#ifndef ANSWER_SLOTS
#define ANSWER_SLOTS 1
#endif
#ifndef HOST_KILLS
#define HOST_KILLS 1
#endif
#ifndef MESSAGE_KILLS
#define MESSAGE_KILLS 1
#endif
#ifndef LOST_BELLS
#define LOST_BELLS 2  // of each side
#endif
#ifndef FLIPS
#define FLIPS 1
#endif
#define PARTIES 2
#define HOST 0
#define MESSAGE 1
#define MAILS (CYCLES * (1 + HOST_KILLS))
#define LOG (MAILS * (WORDS + 4) + 2 * LOST_BELLS + CYCLES)
// The host's places.
#define RINGS 0
#define POSTED 1
#define READY 2
#define ANSWERS_TAKEN 3
#define WORD(i) (4 + (i))
// The message controller's.
#define TAKEN 1
#define ANSWERS_POSTED 2
#define ANSWER(slot, i) (3 + (slot) * WORDS + (i))
#if ANSWER_SLOTS * WORDS + 3 > WORDS + 4
#define PLACES (3 + ANSWER_SLOTS * WORDS)
#else
#define PLACES (4 + WORDS)
#endif
#include "memory.pml"

#ifdef MUTATION_POSTED_RELAXED
#define POST_ORDER RELAXED
#else
#define POST_ORDER RELEASE
#endif

#define DAMAGED 200

byte cycle;                  // that runs; everybody's clock
byte window = 1;             // counted on with each new message controller
byte attached = 1;           // the host's window
byte host_kills = HOST_KILLS;
byte message_kills = MESSAGE_KILLS;
byte host_bells = LOST_BELLS, message_bells = LOST_BELLS;
byte flips = FLIPS;

// The window's counts as their own side sees them; they outlive the host.
byte posted, host_rings, answers_taken;
byte taken, message_rings, answers_posted;
byte sequence_of[MAILS + 2];  // [number of a mail in this window]: the cycle that it is for
bool flipped[MAILS + 2];
bool host_bell_lost, answer_bell_lost;  // and none has rung since
byte accepted;                // the newest cycle that a mail was accepted for, by any message controller

// Whatever the host stores into a window whose owner has died is seen by nobody.
#define INTO_WINDOW(action) \
  if \
  :: attached == window -> action \
  :: else \
  fi

inline ring_host() {
  if
  :: host_bells > 0 -> host_bells--; host_bell_lost = true
  :: host_rings++; store(HOST, RINGS, host_rings, RELEASE); host_bell_lost = false              // model: post.6
  fi
}

active proctype clock() {
  do
  :: cycle < CYCLES - 1 -> cycle++
  :: else -> break
  od
}

active proctype host() {
  View view;
  byte entry, newer;
  byte handed;               // the newest cycle that this process handed a batch over for
  byte rings_seen, announced;
  byte seen, i, word;
begin:
end_idle:
  do
  :: handed < cycle + 1 ->
     atomic { OR_KILLED(host_kills);
              handed = cycle + 1;
              if
              :: attached == window -> load(MESSAGE, view, TAKEN, ACQUIRE, seen)                // model: post.1
              :: else -> seen = posted
              fi }
     if
#ifdef MUTATION_POSTED_OVER_UNTAKEN
     :: false ->
#else
     :: seen != posted ->
#endif
        atomic { OR_KILLED(host_kills); INTO_WINDOW(ring_host()) }                              // model: post.2
     :: else ->
        do
        :: i < WORDS ->
           atomic { OR_KILLED(host_kills);
                    if
                    :: attached == window && flips > 0 ->
                       flips--; flipped[posted + 1] = true; store(HOST, WORD(i), DAMAGED, RELAXED)
                    :: INTO_WINDOW(store(HOST, WORD(i), posted + 1, RELAXED))                   // model: post.3
                    fi;
                    i++ }
        :: else -> break
        od;
        atomic { i = 0; OR_KILLED(host_kills); INTO_WINDOW(store(HOST, READY, posted + 1, RELAXED)) }  // model: post.4
        atomic { OR_KILLED(host_kills);
                 INTO_WINDOW(posted++; sequence_of[posted] = handed;
                             store(HOST, POSTED, posted, POST_ORDER)) }                         // model: post.5
        atomic { OR_KILLED(host_kills); INTO_WINDOW(ring_host()) }                              // model: post.6
     fi;
     seen = 0
  // The trims that the host posts all the time ring, too.
  :: atomic { attached == window && host_bell_lost -> OR_KILLED(host_kills); ring_host() }
  :: atomic { attached == window && (message_rings != rings_seen || announced != answers_taken) ->
              OR_KILLED(host_kills); load(MESSAGE, view, RINGS, ACQUIRE, seen) }                // model: take_answer.1
     if
     :: attached == window && seen != rings_seen ->
        rings_seen = seen;
        atomic { OR_KILLED(host_kills);
                 if
                 :: attached == window -> load(MESSAGE, view, ANSWERS_POSTED, ACQUIRE, announced)  // model: take_answer.2
                 :: else
                 fi }
     :: else
     fi;
     seen = 0;
     if
     :: atomic { attached == window && announced != answers_taken ->
                 assert(announced > answers_taken && announced - answers_taken <= ANSWER_SLOTS) }
        do
        :: i < WORDS && attached == window ->
           atomic { OR_KILLED(host_kills);
                    if
                    :: attached == window ->
                       load(MESSAGE, view, ANSWER(answers_taken % ANSWER_SLOTS, i), RELAXED, word);  // model: take_answer.3
                       assert(word == answers_taken + 1)  // the oldest that waits, whole
                    :: else
                    fi;
                    word = 0; i++ }
        :: else -> break
        od;
        atomic { i = 0; OR_KILLED(host_kills);
                 INTO_WINDOW(answers_taken++;
                             store(HOST, ANSWERS_TAKEN, answers_taken, RELEASE)) }              // model: take_answer.4
     :: else
     fi
#ifndef MUTATION_NEVER_ATTACHED_ANEW
  // It has seen that the message controller is dead, and that a new one serves.
  :: atomic { attached != window ->
              attached = window; rings_seen = 0; announced = 0;
              view.acquired = 0;
              do
              :: i < PLACES -> view.seen[i] = 0; i++
              :: else -> break
              od;
              i = 0 }
#endif
  od;
killed:
  // Another process with nothing of its own but what lies in the window; it sees what its predecessor saw.
  atomic { flipped[posted + 1] = false;  // of a mail that was not posted
           handed = 0; rings_seen = 0; announced = 0; seen = 0; i = 0; goto begin }
}

active proctype message() {
  View view;
  byte entry, newer;
  byte rings_seen, announced, waiting;  // waiting: the cycle of the batch that waits for its start; 0: none
  byte seen, i, word;
  bool is_damaged;
begin:
end_idle:
  do
  :: atomic { host_rings != rings_seen || announced != taken ->
              OR_KILLED(message_kills); load(HOST, view, ANSWERS_TAKEN, ACQUIRE, seen) }        // model: answer.1
     if
#ifdef MUTATION_ANSWERS_NEVER_FULL
     :: false
#else
     :: answers_posted - seen >= ANSWER_SLOTS
#endif
     :: else ->
        atomic { OR_KILLED(message_kills); load(HOST, view, RINGS, ACQUIRE, seen) }             // model: fetch.1
        if
        :: seen != rings_seen ->
           rings_seen = seen;
           atomic { OR_KILLED(message_kills); load(HOST, view, POSTED, ACQUIRE, announced) }    // model: fetch.2
        :: else
        fi;
        if
        :: announced != taken ->
           assert(announced == taken + 1);
           atomic { OR_KILLED(message_kills); load(HOST, view, READY, RELAXED, word);           // model: fetch.3
                    assert(word == announced); word = 0 }
           do
           :: i < WORDS ->
              atomic { OR_KILLED(message_kills); load(HOST, view, WORD(i), RELAXED, word);      // model: fetch.4
                       is_damaged = is_damaged || word != announced; word = 0; i++ }
           :: else -> break
           od;
           assert(is_damaged == flipped[announced]);
           atomic { i = 0; OR_KILLED(message_kills); taken = announced;
                    store(MESSAGE, TAKEN, taken, RELEASE) }                                     // model: fetch.5
           // For the next cycle, and none waits for it: else late, early or old, and answered as such.
           atomic { OR_KILLED(message_kills);
                    if
                    :: waiting <= cycle -> waiting = 0  // it plays
                    :: else
                    fi;
                    if
#ifdef MUTATION_NOT_JUDGED
                    :: !is_damaged ->
#else
                    :: !is_damaged && sequence_of[taken] == cycle + 1 && waiting == 0 ->
#endif
                       assert(waiting == 0 && sequence_of[taken] > cycle && sequence_of[taken] >= accepted);
                       waiting = sequence_of[taken];
                       accepted = waiting
                    :: else
                    fi;
                    is_damaged = false }
           do
           :: i < WORDS ->
              atomic { OR_KILLED(message_kills);
                       store(MESSAGE, ANSWER(answers_posted % ANSWER_SLOTS, i), taken, RELAXED); i++ }  // model: answer.2
           :: else -> break
           od;
           atomic { i = 0; OR_KILLED(message_kills); answers_posted++;
                    store(MESSAGE, ANSWERS_POSTED, answers_posted, RELEASE);                    // model: answer.3
                    assert(answers_posted == taken) }
           atomic { OR_KILLED(message_kills);
                    if
                    :: message_bells > 0 -> message_bells--; answer_bell_lost = true
                    :: message_rings++; store(MESSAGE, RINGS, message_rings, RELEASE);          // model: answer.4
                       answer_bell_lost = false
                    fi }
        :: else
        fi
     fi;
     seen = 0
  od;
killed:
  skip;
  // The memory goes with its owner; the next one makes a new window.
  d_step {
    window++;
    posted = 0; host_rings = 0; answers_taken = 0; taken = 0; message_rings = 0; answers_posted = 0;
    host_bell_lost = false; answer_bell_lost = false;
    rings_seen = 0; announced = 0; waiting = 0; seen = 0; word = 0; is_damaged = false;
    i = 1;
    do
    :: i <= MAILS -> sequence_of[i] = 0; flipped[i] = false; i++
    :: else -> break
    od;
    i = 0;
    do
    :: i <= LOG ->
       log[HOST].place[i] = 0; log[HOST].value[i] = 0; log[HOST].is_release[i] = 0;
       log[MESSAGE].place[i] = 0; log[MESSAGE].value[i] = 0; log[MESSAGE].is_release[i] = 0;
       i++
    :: else -> break
    od;
    log[HOST].length = 0; log[MESSAGE].length = 0;
    view.acquired = 0;
    i = 0;
    do
    :: i < PLACES -> view.seen[i] = 0; i++
    :: else -> break
    od;
    i = 0
  }
  goto begin
}

// When nobody has anything to do any more.
active proctype judge() {
  timeout ->
  assert(attached == window);
  assert(taken == posted);
  assert(answers_posted == taken);
  assert(answers_taken == answers_posted || answer_bell_lost)
}
