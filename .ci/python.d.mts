/** The folder of the package touchdown_service. */
export const SERVICE_HOME: string;
/** Path of an interpreter that has what the service needs. @throws with the line that helps */
export function servicePython(): string;
