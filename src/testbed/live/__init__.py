"""A flight that is flown in real time and broken by hand, in a page of a browser on this machine.

`messages` is all that a page may ask for, and what it is told. `flight` carries it out on a `Session`, `pilot` keeps the time in a
process of its own, of which copies are kept to go back, and `aloft` is that process as the server sees it, with its copies. `page`
is the page, and `server` speaks with the browsers.
"""
