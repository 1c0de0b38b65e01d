export function leanShader(text: string): string;
