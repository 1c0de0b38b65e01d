/** The address of a room in this browser, where a socket's begins with ws:. */
export const TAB_ADDRESS = /^tab:[\w-]{1,32}$/;
