/** Prefix of the address of a world in another tab; that of a socket begins with ws:. */
export const TAB_ADDRESS = /^tab:[\w-]{1,32}$/;

/** Whether an address is of a server whose world is no scenario of the page; '' is the built-in one. */
export const isRealServer = (address: string): boolean => address !== '' && !TAB_ADDRESS.test(address);

/** Most characters of a pilot's name, which other pages show. */
export const MAX_PILOT_NAME = 24;
