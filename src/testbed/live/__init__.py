"""A flight that is flown in real time and broken by hand, in a page of a browser on this machine.

`messages` is all that a page may ask for. `flight` carries it out on a `Session`, `pilot` keeps the time in a process of its own,
of which `copies` are kept to go back, and `aloft` is that process as the server sees it. `frames` says what a page is
told, `page` is the page, and `server` speaks with the browsers.
"""
