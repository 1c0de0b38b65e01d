import tseslint from 'typescript-eslint';

export default tseslint.config(
  { ignores: ['dist/', 'node_modules/', 'src/wire/generated/', '.vitest-attachments/'] },
  {
    files: ['**/*.ts'],
    extends: [tseslint.configs.strictTypeChecked],
    languageOptions: { parserOptions: { projectService: true } },
    rules: {
      // A type import must vanish from the bundle, and the import table tells the two kinds apart.
      '@typescript-eslint/consistent-type-imports': ['error', { fixStyle: 'separate-type-imports' }],
      // A number or a boolean in a message is what a template is for.
      '@typescript-eslint/restrict-template-expressions': [
        'error',
        { allowNumber: true, allowBoolean: true },
      ],
      // With noUncheckedIndexedAccess a typed array's `row[i]` may be undefined to the compiler alone;
      // in a substep a run-time check for it would cost and could never fire.
      '@typescript-eslint/no-non-null-assertion': 'off',
      // `while (true)` with a reasoned exit reads better than a flag.
      '@typescript-eslint/no-unnecessary-condition': [
        'error',
        { allowConstantLoopConditions: 'only-allowed-literals' },
      ],
      // Arrow shorthands that return nothing: `() => queue.push(x)`.
      '@typescript-eslint/no-confusing-void-expression': ['error', { ignoreArrowShorthand: true }],
      // A double that went through a NaN compare is equal to nothing; === is the one equality used.
      eqeqeq: 'error',
      // Code that is not run is not kept.
      '@typescript-eslint/no-unused-vars': ['error', { argsIgnorePattern: '^_' }],
      // Five arguments at a call site are the most that can be read.
      'max-params': ['error', 5],
    },
  },
  {
    // A file is read at one sitting and a function on one screen. Tests are exempt: the function around a list of cases is as long as
    // the list.
    files: ['src/**/*.ts'],
    rules: {
      'max-lines': ['error', 250],
      'max-lines-per-function': ['error', { max: 60, skipBlankLines: true, skipComments: true }],
    },
  },
  {
    files: ['**/*.{js,mjs}'],
    extends: [tseslint.configs.recommended],
    rules: { eqeqeq: 'error' },
  },
);
