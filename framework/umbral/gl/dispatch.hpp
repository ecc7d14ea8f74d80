#pragma once

/// The table through which every OpenGL call goes. Private to libumbral-gl.
namespace umbral::gl {

#pragma GCC visibility push(hidden)

using EntryAddress = void (*)();

/// Fills the table with what `address_of(name)` gives, so that calls reach the back end.
void connect(EntryAddress (*address_of)(const char* name));

/// Empties the table: from now on every call aborts with a message.
void disconnect();

#pragma GCC visibility pop

}
