// Start-up and re-attachment (process/listening_socket.cpp, msgclient/memory_block_server.cpp, remote_source.cpp):
// a message controller that makes a memory block and gives it out, and CLIENTS processes that connect, open one
// topic to write it (whoever is refused stays as a reader), and connect anew when they see that the message
// controller has ended. Each is killed before any of its steps and started again by whoever supervises it.
//
// Shown: no deadlock; one message controller serves at a time; a topic has one writer in a block; nobody is
// refused for the claim of somebody who had left or given it back before he asked, or sees somebody in the
// directory who had left before he connected; and, if every process goes on being given time (weak fairness),
// all clients are attached to the message controller that serves, for good, and the topic is written there.
#ifndef CLIENTS
#define CLIENTS 2
#endif
#ifndef SERVERS
#define SERVERS 1  // 2: somebody starts a second copy
#endif
#ifndef SERVER_KILLS
#define SERVER_KILLS 1
#endif
#ifndef CLIENT_KILLS
#define CLIENT_KILLS 1
#endif
#ifndef GIVEN_BACK
#define GIVEN_BACK 1  // times that a writer gives its claim back and asks for it again
#endif
#ifndef SILENCES
#define SILENCES 1  // times that a client takes a message controller that lives for one that hangs
#endif
#define CONNECTIONS 3  // two that live, and one whose end has not been seen
#define NOBODY 255

mtype = {nothing, hello, open, directory, granted, refused};
mtype = {unused, in_backlog, accepted};

typedef Connection {
  mtype state = unused;
  byte server;        // the block that it leads to
  bool left;          // the client has closed it, or was killed
  // Packets that lie there. A client waits for the answer to what it asks, so a release comes first.
  bool gives_back;
  mtype asked = nothing;
  mtype answer = nothing;
  byte void_claim;    // number of the claim that was void when it connected, or asked; 0: none
};
Connection connection[CONNECTIONS];

byte locked = NOBODY;      // the lock file's holder
byte named;                // the block whose listener the socket's path leads to
byte listening;            // the block that is given out; 0: none
byte blocks;               // made so far: each has a number
byte serving;              // message controllers that serve
byte server_kills = SERVER_KILLS, client_kills = CLIENT_KILLS, silences = SILENCES, given_back = GIVEN_BACK;

// The topic in the block that is given out.
byte holder = NOBODY;      // a connection
byte claims;               // made so far, in this block
byte attached[CLIENTS];    // the block that a client has mapped; 0: none
bool writes[CLIENTS];      // it may store into the topic there
byte writers[SERVERS + SERVER_KILLS + 1];  // [block]: processes that may

#define SOMETHING_CAME(i) (connection[i].server == me && \
  (connection[i].state == in_backlog || (connection[i].state == accepted && \
    (connection[i].left || connection[i].gives_back || connection[i].asked != nothing))))
#define SOMETHING_TO_DO (SOMETHING_CAME(0) || SOMETHING_CAME(1) || SOMETHING_CAME(2))

#define ITS_TURN(i) (connection[i % CONNECTIONS].server == me && \
  connection[i % CONNECTIONS].state == (i < CONNECTIONS -> accepted : in_backlog))

#define OR_KILLED(budget) \
  if \
  :: skip \
  :: budget > 0 -> budget--; goto killed \
  fi

inline forget(i) {
  connection[i].state = unused; connection[i].server = 0; connection[i].left = false;
  connection[i].gives_back = false; connection[i].asked = nothing; connection[i].answer = nothing;
  connection[i].void_claim = 0
}

// One packet of connection i, or its end.
inline take_request(i) {
  if
  :: connection[i].gives_back ->                                                                // model: serve.3
     connection[i].gives_back = false;
     if
     :: holder == i -> holder = NOBODY
     :: else  // unreached: only a writer gives back
     fi
  :: !connection[i].gives_back && connection[i].asked == hello ->                               // model: serve.1
     connection[i].asked = nothing; connection[i].answer = directory;
#ifndef MUTATION_DEPARTED_LISTED
     if
     :: holder != NOBODY && connection[holder].left -> holder = NOBODY                          // model: serve.7
     :: else
     fi;
#endif
     // The directory that it sees names nobody as a writer who had left before it connected.
     assert(holder == NOBODY || connection[i].void_claim != claims);
     connection[i].void_claim = 0
  :: !connection[i].gives_back && connection[i].asked == open ->
     connection[i].asked = nothing; answer_open(i)
  :: !connection[i].gives_back && connection[i].asked == nothing && connection[i].left ->       // model: serve.4
     if
     :: holder == i -> holder = NOBODY
     :: else
     fi;
     forget(i)
  :: !connection[i].gives_back && connection[i].asked == nothing && !connection[i].left
  fi
}

// Before somebody is refused, it is looked whether the holder has left or given back meanwhile.
inline answer_open(i) {
#ifndef MUTATION_REFUSED_AT_ONCE
  if
  :: holder != NOBODY && connection[holder].left -> holder = NOBODY                             // model: serve.5
  :: holder != NOBODY && !connection[holder].left && connection[holder].gives_back ->           // model: serve.6
     connection[holder].gives_back = false; holder = NOBODY
  :: else
  fi;
#endif
  if
  :: holder == NOBODY -> holder = i; claims++; connection[i].answer = granted                   // model: serve.2
  :: else ->
     assert(connection[i].void_claim == 0 || connection[i].void_claim != claims);
     connection[i].answer = refused
  fi
}

active [SERVERS] proctype message_controller() {
  byte me, i, at;  // me: the block that this process has made; 0: none
begin:
  atomic { blocks++; me = blocks }
#ifndef MUTATION_NO_LOCK
  // Else another one serves it, and this one is refused; it is started again later.
end_second:
  atomic { locked == NOBODY -> locked = _pid }                                                  // model: start.1
#endif
  atomic { OR_KILLED(server_kills); named = 0 }                                                 // model: start.2
  atomic { OR_KILLED(server_kills); named = me }                                                // model: start.3
  atomic { OR_KILLED(server_kills); listening = me; serving++; assert(serving == 1);            // model: start.4
           holder = NOBODY; claims = 0 }
end_idle:
  do
  :: SOMETHING_TO_DO ->
     // Those that it knows, in their turn; then whoever waits to be accepted.
     do
     :: i < 2 * CONNECTIONS ->
        atomic { OR_KILLED(server_kills);
                 do
                 :: i < 2 * CONNECTIONS && !ITS_TURN(i) -> i++
                 :: else -> break
                 od;
                 if
                 :: i < 2 * CONNECTIONS ->
                    at = i % CONNECTIONS;
                    connection[at].state = accepted;                                            // model: accept.1
                    take_request(at);
                    at = 0; i++
                 :: else
                 fi }
     :: else -> break
     od;
     i = 0
  :: atomic { server_kills > 0 -> server_kills--; goto killed }
  od;
killed:
  // The system closes its sockets and gives back its lock; the socket's file stays behind.
  atomic {
    if
    :: listening == me -> listening = 0; serving--
    :: else
    fi;
    if
    :: locked == _pid -> locked = NOBODY
    :: else  // unreached: but for a second copy without a lock
    fi;
    i = 0;
    do
    :: i < CONNECTIONS ->
       if
       :: connection[i].server == me && connection[i].left -> forget(i)
       :: else
       fi;
       i++
    :: else -> break
    od;
    i = 0; at = 0; me = 0;
    goto begin
  }
}

// What a client sees of a connection whose other end has died.
#define HUNG_UP (connection[at].server != listening)

inline close_connection() {
  if
  :: at == NOBODY
  :: at != NOBODY && HUNG_UP -> forget(at)
  :: at != NOBODY && !HUNG_UP -> connection[at].left = true
  fi;
  at = NOBODY
}
inline stop_writing(who) {
  if
  :: writes[who] -> writes[who] = false; writers[attached[who]]--
  :: else
  fi
}

active [CLIENTS] proctype client() {
  byte who = _pid - SERVERS;
  byte at = NOBODY;  // its connection
begin:
  // Tries until there is one to connect to; the socket of one that has died, or does not listen yet, refuses.
end_nobody_serves:
  atomic {
    if                                                                                          // model: attach.1
    :: listening != 0 && named == listening && connection[0].state == unused -> at = 0
    :: listening != 0 && named == listening && connection[0].state != unused && connection[1].state == unused -> at = 1
    :: listening != 0 && named == listening && connection[0].state != unused && connection[1].state != unused &&
       connection[2].state == unused -> at = 2
    fi;
    connection[at].state = in_backlog; connection[at].server = listening;
    if
    :: holder != NOBODY && connection[holder].left -> connection[at].void_claim = claims
    :: else
    fi
  }
  atomic { OR_KILLED(client_kills); connection[at].asked = hello }                                        // model: attach.2
  if
  :: atomic { connection[at].answer == directory && !HUNG_UP ->                                 // model: attach.3
              connection[at].answer = nothing; attached[who] = connection[at].server }
  :: HUNG_UP -> goto lost
  :: atomic { silences > 0 -> silences--; goto lost }
  :: atomic { client_kills > 0 -> client_kills--; goto killed }
  fi;
ask:
  atomic { OR_KILLED(client_kills);                                                             // model: attach.4
           if
           :: holder != NOBODY && (connection[holder].left || connection[holder].gives_back) ->
              connection[at].void_claim = claims
           :: else -> connection[at].void_claim = 0
           fi;
           connection[at].asked = open }
  if
  :: atomic { connection[at].answer == granted && !HUNG_UP ->                                   // model: attach.5
              connection[at].answer = nothing;
              writes[who] = true; writers[attached[who]]++;
              assert(writers[attached[who]] == 1) }
  :: atomic { connection[at].answer == refused && !HUNG_UP -> connection[at].answer = nothing }
  :: HUNG_UP -> goto lost
  :: atomic { silences > 0 -> silences--; goto lost }
  :: atomic { client_kills > 0 -> client_kills--; goto killed }
  fi;
end_attached:
  if
#ifndef MUTATION_HANG_UP_NOT_WATCHED
  :: HUNG_UP -> goto lost                                                                       // model: watch.1
#endif
  :: atomic { silences > 0 -> silences--; goto lost }                                           // model: watch.2
  :: atomic { writes[who] && given_back > 0 && !HUNG_UP && !connection[at].gives_back ->
              given_back--; stop_writing(who); connection[at].gives_back = true;                            // model: release.1
              goto ask }
  :: atomic { client_kills > 0 -> client_kills--; goto killed }
  fi;
lost:
#ifdef MUTATION_MEMORY_KEPT
  atomic { close_connection() }
  atomic { OR_KILLED(client_kills); stop_writing(who); attached[who] = 0; goto begin }
#else
  atomic { OR_KILLED(client_kills); stop_writing(who); attached[who] = 0 }
  atomic { close_connection(); goto begin }                                                     // model: watch.3
#endif
killed:
  atomic { stop_writing(who); attached[who] = 0; close_connection(); goto begin }
}

// For good: all clients attached to what is given out, and the topic written there.
#define ALL_ATTACHED (listening != 0 && attached[0] == listening && attached[CLIENTS - 1] == listening)
ltl all_return { <>[] (ALL_ATTACHED && writers[listening] == 1) }

#ifdef TIME_GOES_ON
// Liveness is about endless runs; this makes one of what is quiet. Not for the search for deadlocks.
bool tick;
active proctype time() {
  do
  :: tick = !tick
  od
}
#endif
